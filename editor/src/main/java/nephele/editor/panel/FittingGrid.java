package nephele.editor.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;

/** Lays components out in equal cells, in as many columns as show every text whole, up to a number; at least one. */
final class FittingGrid implements LayoutManager {
    private static final int GAP_POINTS = 2;

    private final int mostColumns;
    private int laidOutColumns;

    FittingGrid(int mostColumns) {
        this.mostColumns = mostColumns;
    }

    private static int gap() {
        return UIScale.scale(GAP_POINTS);
    }

    private static Dimension cell(Container parent) {
        int width = 1;
        int height = 1;
        for (Component child : parent.getComponents()) {
            width = Math.max(width, child.getPreferredSize().width);
            height = Math.max(height, child.getPreferredSize().height);
        }
        return new Dimension(width, height);
    }

    private int columns(Container parent) {
        int fitting = (parent.getWidth() + gap()) / (cell(parent).width + gap());
        return Math.max(1, Math.min(mostColumns, fitting));
    }

    /** The height follows from the width, which the container has to have first. */
    @Override
    public Dimension preferredLayoutSize(Container parent) {
        Dimension cell = cell(parent);
        int columns = columns(parent);
        int rows = (parent.getComponentCount() + columns - 1) / columns;
        return new Dimension(cell.width, Math.max(0, rows * (cell.height + gap()) - gap()));
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        return preferredLayoutSize(parent);
    }

    @Override
    public void layoutContainer(Container parent) {
        int columns = columns(parent);
        if (columns != laidOutColumns && parent instanceof JComponent component) {
            // The height was asked for at another width; in the middle of a layout nothing can become invalid.
            laidOutColumns = columns;
            SwingUtilities.invokeLater(component::revalidate);
        }
        int height = cell(parent).height;
        int width = (parent.getWidth() - (columns - 1) * gap()) / columns;
        for (int i = 0; i < parent.getComponentCount(); i++) {
            parent.getComponent(i)
                    .setBounds(i % columns * (width + gap()), i / columns * (height + gap()), width, height);
        }
    }

    @Override
    public void addLayoutComponent(String name, Component component) {
        // The components have no names.
    }

    @Override
    public void removeLayoutComponent(Component component) {
        // Nothing is kept of it.
    }
}

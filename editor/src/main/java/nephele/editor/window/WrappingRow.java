package nephele.editor.window;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.LayoutManager;

/** Lays components out in rows from left to right; a container that is narrow gets more rows, so nothing is cut off. */
final class WrappingRow implements LayoutManager {
    private static final int GAP_POINTS = 2;

    @Override
    public void addLayoutComponent(String name, Component component) {}

    @Override
    public void removeLayoutComponent(Component component) {}

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        int width = parent.getWidth() > 0 ? parent.getWidth() : Integer.MAX_VALUE;
        return arranged(parent, width, false);
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        return preferredLayoutSize(parent);
    }

    @Override
    public void layoutContainer(Container parent) {
        arranged(parent, parent.getWidth(), true);
    }

    private static Dimension arranged(Container parent, int width, boolean places) {
        Insets insets = parent.getInsets();
        int gap = UIScale.scale(GAP_POINTS);
        int x = insets.left;
        int y = insets.top;
        int rowHeight = 0;
        int widest = 0;
        for (Component child : parent.getComponents()) {
            Dimension size = child.getPreferredSize();
            if (x > insets.left && x + size.width > width - insets.right) {
                x = insets.left;
                y += rowHeight + gap;
                rowHeight = 0;
            }
            if (places) {
                child.setBounds(x, y, size.width, size.height);
            }
            x += size.width + gap;
            widest = Math.max(widest, x);
            rowHeight = Math.max(rowHeight, size.height);
        }
        return new Dimension(widest + insets.right, y + rowHeight + insets.bottom);
    }
}

package nephele.editor.window.file;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import javax.swing.JList;

/** Runs something when a row of a list is clicked twice. */
final class DoubleClick extends MouseAdapter {
    private final JList<?> list;
    private final Runnable effect;

    private DoubleClick(JList<?> list, Runnable effect) {
        this.list = list;
        this.effect = effect;
    }

    static void on(JList<?> list, Runnable effect) {
        list.addMouseListener(new DoubleClick(list, effect));
    }

    @Override
    public void mouseClicked(MouseEvent event) {
        int row = list.locationToIndex(event.getPoint());
        if (event.getClickCount() == 2
                && row >= 0
                && list.getCellBounds(row, row).contains(event.getPoint())) {
            effect.run();
        }
    }
}

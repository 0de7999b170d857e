package nephele.editor.window;

import java.awt.BorderLayout;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;

/** The viewport between its slots, with splitters whose places are shares of the window. */
final class SlotLayout extends JPanel {
    private static final long serialVersionUID = 1;
    private static final double LEFT_SHARE = 0.18;
    private static final double RIGHT_SHARE = 0.7;
    private static final double BOTTOM_SHARE = 0.78;

    private final transient Map<String, JSplitPane> splits = new LinkedHashMap<>();
    private final transient Map<String, Double> shares = new LinkedHashMap<>();
    private boolean isPlaced;

    /** @param kept shares by name of the splitter, as {@link #shares} returned them */
    SlotLayout(JComponent viewport, EditorSlots slots, Map<String, Double> kept) {
        super(new BorderLayout());
        shares.put("left", LEFT_SHARE);
        shares.put("right", RIGHT_SHARE);
        shares.put("bottom", BOTTOM_SHARE);
        kept.forEach((name, share) -> shares.computeIfPresent(name, (known, before) -> share));
        JComponent middle = viewport;
        if (slots.bottom() != null) {
            middle = split("bottom", JSplitPane.VERTICAL_SPLIT, middle, slots.bottom());
        }
        if (slots.right() != null) {
            middle = split("right", JSplitPane.HORIZONTAL_SPLIT, middle, slots.right());
        }
        if (slots.left() != null) {
            middle = split("left", JSplitPane.HORIZONTAL_SPLIT, slots.left(), middle);
        }
        add(middle);
    }

    private JSplitPane split(String name, int orientation, JComponent first, JComponent second) {
        JSplitPane split = new JSplitPane(orientation, true, first, second);
        split.setName(name);
        split.setBorder(BorderFactory.createEmptyBorder());
        split.setResizeWeight(name.equals("left") ? 0 : 1);
        splits.put(name, split);
        return split;
    }

    @Override
    public void doLayout() {
        super.doLayout();
        if (!isPlaced && getWidth() > 0 && getHeight() > 0) {
            isPlaced = true;
            place();
        }
    }

    /** The outermost splitter was made last; the size of an inner one follows from it. */
    private void place() {
        for (String name : new String[] {"left", "right", "bottom"}) {
            JSplitPane split = splits.get(name);
            if (split != null) {
                split.setDividerLocation((int) Math.round(length(split) * shares.get(name)));
                // Without a display, validate() lays out nothing.
                split.doLayout();
            }
        }
    }

    private static int length(JSplitPane split) {
        return split.getOrientation() == JSplitPane.HORIZONTAL_SPLIT ? split.getWidth() : split.getHeight();
    }

    /** Returns the places of the splitters by name, to be kept in the settings. */
    Map<String, Double> shares() {
        if (isPlaced) {
            splits.forEach((name, split) ->
                    shares.put(name, split.getDividerLocation() / (double) Math.max(1, length(split))));
        }
        return Map.copyOf(shares);
    }
}

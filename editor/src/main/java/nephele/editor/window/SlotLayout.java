package nephele.editor.window;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;

/** The viewport between its slots, with splitters whose places are fractions of the window. */
final class SlotLayout extends JPanel {
    private static final long serialVersionUID = 1;
    private static final double LEFT_FRACTION = 0.18;
    private static final double RIGHT_FRACTION = 0.7;
    private static final double BOTTOM_FRACTION = 0.78;
    /** What the texts beside and below the viewport need, points: at a large scale more than their fractions. */
    private static final int LEFT_POINTS = 224;

    private static final int RIGHT_POINTS = 304;
    private static final int BOTTOM_POINTS = 140;
    /** The viewport keeps as much of a small window. */
    private static final double LEAST_VIEWPORT_FRACTION = 0.5;

    private final transient Map<String, JSplitPane> splits = new LinkedHashMap<>();
    private final transient Map<String, Double> fractions = new LinkedHashMap<>();
    private final transient Set<String> chosen = new HashSet<>();
    private boolean isPlaced;

    /** @param kept the user's fractions by name of the splitter */
    SlotLayout(JComponent viewport, EditorSlots slots, Map<String, Double> kept) {
        super(new BorderLayout());
        fractions.put("left", LEFT_FRACTION);
        fractions.put("right", RIGHT_FRACTION);
        fractions.put("bottom", BOTTOM_FRACTION);
        kept.forEach((name, fraction) -> fractions.computeIfPresent(name, (known, before) -> fraction));
        chosen.addAll(kept.keySet());
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
                split.setDividerLocation((int) Math.round(length(split) * fraction(name, length(split))));
                // Without a display, validate() lays out nothing.
                split.doLayout();
            }
        }
    }

    /** Returns the user's choice, or else a place at which the texts have room. */
    private double fraction(String name, int length) {
        double fraction = fractions.get(name);
        if (chosen.contains(name)) {
            return fraction;
        }
        return switch (name) {
            case "left" ->
                Math.min(1 - LEAST_VIEWPORT_FRACTION, Math.max(fraction, UIScale.scale(LEFT_POINTS) / (double) length));
            case "right" ->
                Math.max(
                        LEAST_VIEWPORT_FRACTION, Math.min(fraction, 1 - UIScale.scale(RIGHT_POINTS) / (double) length));
            default ->
                Math.max(
                        LEAST_VIEWPORT_FRACTION,
                        Math.min(fraction, 1 - UIScale.scale(BOTTOM_POINTS) / (double) length));
        };
    }

    private static int length(JSplitPane split) {
        return split.getOrientation() == JSplitPane.HORIZONTAL_SPLIT ? split.getWidth() : split.getHeight();
    }
}

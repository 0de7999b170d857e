package nephele.editor.widget;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.util.List;
import javax.swing.Icon;
import javax.swing.UIManager;

/** A symbol of lines on a square of 24 units, in the colour of the component's text; a letter if there is no drawing. */
final class Symbol implements Icon {
    private static final double UNITS = 24;
    private static final float LINE_UNITS = 1.7f;

    private final List<Shape> lines;
    private final List<Shape> areas;
    private final String letter;
    private final int sidePoints;

    /** @param sidePoints width and height at 100 % */
    Symbol(List<Shape> lines, List<Shape> areas, String letter, int sidePoints) {
        this.lines = lines;
        this.areas = areas;
        this.letter = letter;
        this.sidePoints = sidePoints;
    }

    @Override
    public void paintIcon(Component component, Graphics graphics, int x, int y) {
        Graphics2D g = (Graphics2D) graphics.create();
        try {
            g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
            g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
            g.setColor(colour(component));
            g.translate(x, y);
            g.scale(getIconWidth() / UNITS, getIconHeight() / UNITS);
            g.setStroke(new BasicStroke(LINE_UNITS, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            lines.forEach(g::draw);
            areas.forEach(g::fill);
            if (lines.isEmpty() && areas.isEmpty()) {
                drawLetter(g, component);
            }
        } finally {
            g.dispose();
        }
    }

    private static Color colour(Component component) {
        Color disabled = UIManager.getColor("Label.disabledForeground");
        return component.isEnabled() || disabled == null ? component.getForeground() : disabled;
    }

    private void drawLetter(Graphics2D g, Component component) {
        g.setFont(component.getFont().deriveFont(Font.BOLD, letter.length() > 1 ? 12f : 16f));
        FontMetrics metrics = g.getFontMetrics();
        float left = (float) (UNITS - metrics.stringWidth(letter)) / 2;
        g.drawString(letter, left, (float) (UNITS - metrics.getHeight()) / 2 + metrics.getAscent());
    }

    @Override
    public int getIconWidth() {
        return UIScale.scale(sidePoints);
    }

    @Override
    public int getIconHeight() {
        return UIScale.scale(sidePoints);
    }
}

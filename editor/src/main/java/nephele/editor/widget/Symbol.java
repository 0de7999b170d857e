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
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import javax.swing.Icon;
import javax.swing.UIManager;

/**
 * A symbol of lines on a square of 24 units, in the colour of the component's text; a letter if there is no drawing. A
 * drawing has parts between bars. Each part is an outline, or an area if it begins with {@code *}: points {@code x,y},
 * {@code z} closes, {@code o x,y,r} is a circle and {@code o x,y,rx,ry} an ellipse.
 */
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

    /** Returns the drawings of a table by their names, one a line. */
    static Map<String, String> table(String lines) {
        return lines.lines()
                .map(line -> line.split("\\s+", 2))
                .collect(Collectors.toUnmodifiableMap(row -> row[0], row -> row[1]));
    }

    /**
     * Returns the symbol of a drawing.
     *
     * @param sidePoints width and height at 100 %
     */
    static Icon of(String drawing, int sidePoints) {
        List<Shape> lines = new ArrayList<>();
        List<Shape> areas = new ArrayList<>();
        for (String part : drawing.split("\\|")) {
            boolean isArea = part.startsWith("*");
            (isArea ? areas : lines).add(shape(isArea ? part.substring(1) : part));
        }
        return new Symbol(lines, areas, "", sidePoints);
    }

    private static Shape shape(String part) {
        Path2D path = new Path2D.Double();
        boolean isEllipse = part.startsWith("o ");
        for (String word : (isEllipse ? part.substring(2) : part).split(" ")) {
            String[] numbers = word.split(",");
            if (isEllipse) {
                return ellipse(numbers);
            } else if (word.equals("z")) {
                path.closePath();
            } else if (path.getCurrentPoint() == null) {
                path.moveTo(Double.parseDouble(numbers[0]), Double.parseDouble(numbers[1]));
            } else {
                path.lineTo(Double.parseDouble(numbers[0]), Double.parseDouble(numbers[1]));
            }
        }
        return path;
    }

    private static Shape ellipse(String... numbers) {
        double radiusX = Double.parseDouble(numbers[2]);
        double radiusY = Double.parseDouble(numbers[numbers.length - 1]);
        return new Ellipse2D.Double(
                Double.parseDouble(numbers[0]) - radiusX,
                Double.parseDouble(numbers[1]) - radiusY,
                2 * radiusX,
                2 * radiusY);
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

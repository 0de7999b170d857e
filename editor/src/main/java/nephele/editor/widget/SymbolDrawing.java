package nephele.editor.widget;

import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import javax.swing.Icon;

/**
 * The notation of symbols: parts between bars. Each part is an outline, or an area if it begins with {@code *}: points
 * {@code x,y} on a square of 24 units, {@code z} closes, {@code o x,y,r} is a circle and {@code o x,y,rx,ry} an ellipse.
 */
final class SymbolDrawing {
    private SymbolDrawing() {}

    /** Returns the drawings of a table by their names, one a line. */
    static Map<String, String> table(String lines) {
        return lines.lines()
                .map(line -> line.split("\\s+", 2))
                .collect(Collectors.toUnmodifiableMap(row -> row[0], row -> row[1]));
    }

    /** @param sidePoints width and height at 100 % */
    static Icon icon(String drawing, int sidePoints) {
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
}

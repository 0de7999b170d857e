package nephele.editor.window.file;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;

/**
 * A small plan of a level, seen from above. It needs no OpenGL: whatever has ended an editor can't end the dialogue that
 * shows it.
 */
final class PlanPicture {
    private static final int MARGIN = 10;
    private static final Color PAPER = new Color(0x20262e);
    private static final Color FILL = new Color(120, 170, 220, 38);
    private static final Color LINE = new Color(150, 195, 235, 170);
    private static final Color LAMP = new Color(0xf2c14e);
    private static final Color PLAYER = new Color(0x6fcf7c);
    private static final double DOT = 7;

    /** True if the plan is turned by a quarter, because the level is deeper than wide. */
    private final boolean isTurned;

    private final double minAcross;
    private final double minDown;
    private final double pixelsPerMetre;
    private final double left;
    private final double top;

    private PlanPicture(List<Vec3> points, int width, int height) {
        isTurned = extent(points, Vec3::z) > extent(points, Vec3::x);
        minAcross = points.stream().mapToDouble(this::across).min().orElse(0);
        minDown = points.stream().mapToDouble(this::down).min().orElse(0);
        double wide = extent(points, this::across);
        double deep = extent(points, this::down);
        double fit = Math.min((width - 2 * MARGIN) / Math.max(wide, 1), (height - 2 * MARGIN) / Math.max(deep, 1));
        pixelsPerMetre = fit;
        left = (width - fit * wide) / 2;
        top = (height - fit * deep) / 2;
    }

    private static double extent(List<Vec3> points, ToDoubleFunction<Vec3> axis) {
        double least = points.stream().mapToDouble(axis).min().orElse(0);
        return points.stream().mapToDouble(axis).max().orElse(0) - least;
    }

    private double across(Vec3 point) {
        return isTurned ? -point.z() : point.x();
    }

    private double down(Vec3 point) {
        return isTurned ? point.x() : point.z();
    }

    static BufferedImage of(Level level, int width, int height) {
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = picture.createGraphics();
        try {
            graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            graphics.setColor(PAPER);
            graphics.fillRect(0, 0, width, height);
            draw(level, graphics, width, height);
        } finally {
            graphics.dispose();
        }
        return picture;
    }

    private static void draw(Level level, Graphics2D graphics, int width, int height) {
        List<Brush.BrushFace> faces = new ArrayList<>();
        level.solids().forEach(solid -> brush(solid).ifPresent(brush -> faces.addAll(upper(brush))));
        faces.sort(Comparator.comparingDouble(face -> face.polygon().get(0).y()));
        List<Vec3> points = new ArrayList<>();
        faces.forEach(face -> points.addAll(face.polygon()));
        level.lights().stream()
                .map(PlanPicture::place)
                .flatMap(Optional::stream)
                .forEach(points::add);
        Optional.ofNullable(level.player()).ifPresent(player -> points.add(player.feet()));
        PlanPicture plan = new PlanPicture(points, width, height);
        graphics.setStroke(new BasicStroke(1));
        faces.forEach(face -> plan.draw(face.polygon(), graphics));
        graphics.setColor(LAMP);
        level.lights().stream()
                .map(PlanPicture::place)
                .flatMap(Optional::stream)
                .forEach(at -> graphics.fill(plan.dot(at)));
        graphics.setColor(PLAYER);
        Optional.ofNullable(level.player()).ifPresent(player -> graphics.fill(plan.dot(player.feet())));
    }

    private static Optional<Brush> brush(Solid solid) {
        try {
            return Optional.of(Brush.of(solid));
        } catch (IllegalArgumentException broken) {
            return Optional.empty();
        }
    }

    private static List<Brush.BrushFace> upper(Brush brush) {
        return brush.faces().stream().filter(face -> area(face.polygon()) < 0).toList();
    }

    /** Returns twice the area in the plan; less than 0 where the polygon looks up. */
    private static double area(List<Vec3> polygon) {
        double sum = 0;
        for (int i = 0; i < polygon.size(); i++) {
            Vec3 from = polygon.get(i);
            Vec3 to = polygon.get((i + 1) % polygon.size());
            sum += from.x() * to.z() - to.x() * from.z();
        }
        return sum;
    }

    private static Optional<Vec3> place(Light light) {
        if (light instanceof Light.Point point) {
            return Optional.of(point.position());
        }
        return light instanceof Light.Spot spot ? Optional.of(spot.position()) : Optional.empty();
    }

    private void draw(List<Vec3> polygon, Graphics2D graphics) {
        Path2D path = new Path2D.Double();
        for (Vec3 point : polygon) {
            if (path.getCurrentPoint() == null) {
                path.moveTo(x(point), y(point));
            } else {
                path.lineTo(x(point), y(point));
            }
        }
        path.closePath();
        graphics.setColor(FILL);
        graphics.fill(path);
        graphics.setColor(LINE);
        graphics.draw(path);
    }

    private Ellipse2D dot(Vec3 at) {
        return new Ellipse2D.Double(x(at) - DOT / 2, y(at) - DOT / 2, DOT, DOT);
    }

    private double x(Vec3 point) {
        return left + pixelsPerMetre * (across(point) - minAcross);
    }

    private double y(Vec3 point) {
        return top + pixelsPerMetre * (down(point) - minDown);
    }
}

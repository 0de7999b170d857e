package nephele.host.draw;

import java.util.List;
import nephele.engine.render.frame.Quality;

/**
 * The points of quality among which a frame rate is held: each costs more than the one before and is nearer to the
 * exact picture; `trade quality pictureResolution` measures both.
 *
 * @param points the cheapest first
 * @param start index of the point of the first frames
 */
public record QualityFront(List<Point> points, int start) {
    /**
     * A point of the front.
     *
     * @param name for players
     * @param cost of a frame, relative to {@code high}
     */
    public record Point(String name, Quality quality, double cost) {}

    /**
     * On a software renderer pixels are the cost, and then the light of sun and lamps where it need not be drawn live: the
     * costs are those of levels with baked light. Below half the pixels along a side weights along edges keep the picture
     * from showing the squares it is made of (docs/decisions/performance.md).
     */
    public static final QualityFront SOFTWARE = new QualityFront(
            List.of(
                    new Point("resolution 0.25", small(0.25), 0.19),
                    new Point("low", Quality.LOW, 0.24),
                    new Point("resolution 0.65", Quality.LOW.with("pictureResolution", 0.65), 0.33),
                    new Point("resolution 0.5", live(0.5), 0.4),
                    new Point("resolution 0.6", live(0.6), 0.5),
                    new Point("medium", Quality.MEDIUM, 0.64),
                    new Point("resolution 0.85", Quality.MEDIUM.with("pictureResolution", 0.85), 0.82),
                    new Point("high", Quality.HIGH, 1),
                    new Point("ultra", Quality.ULTRA, 2.5)),
            1);

    /** Costs on a graphics card differ from card to card: these only have the right order. */
    public static final QualityFront HARDWARE = new QualityFront(
            List.of(
                    new Point("low", Quality.LOW.onHardware(), 0.35),
                    new Point("medium", Quality.MEDIUM.onHardware(), 0.7),
                    new Point("high", Quality.HIGH.onHardware(), 1),
                    new Point("ultra", Quality.ULTRA.onHardware(), 1.7)),
            3);

    public QualityFront {
        points = List.copyOf(points);
    }

    private static Quality small(double resolution) {
        return Quality.LOW.with("pictureResolution", resolution).with("upscale", Quality.Upscale.EDGE_ADAPTIVE);
    }

    private static Quality live(double resolution) {
        return Quality.LOW.with("pictureResolution", resolution).with("directLight", Quality.DirectLight.LIVE);
    }

    /** Returns the point of the first frames. */
    public Point first() {
        return points.get(start);
    }

    public static QualityFront of(boolean software) {
        return software ? SOFTWARE : HARDWARE;
    }
}

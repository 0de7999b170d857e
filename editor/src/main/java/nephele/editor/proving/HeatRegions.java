package nephele.editor.proving;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.engine.level.layout.FacePieces;
import nephele.engine.math.Vec3;

/**
 * Makes the marks of a heat map: neighbouring cells with the same result as one area, with a pattern of lines, so that
 * results differ without colours: none where a portal fits, slanted where it slides, crossed where it is refused, and
 * crossed widely on a surface that takes none.
 */
public final class HeatRegions {
    private static final double CONVEX = 1e-6;
    private static final double CLOSE_METRES = 0.25;
    private static final double WIDE_METRES = 1;
    /** Lines of one direction on one area; beyond, they are farther apart. */
    private static final int MOST_LINES = 48;
    /** Beyond, lines are farther apart, as every frame of a flight draws them all. */
    private static final int MANY_SURFACES = 5000;

    private final List<Mark> marks = new ArrayList<>();

    private final double coarser;

    private HeatRegions(double coarser) {
        this.coarser = coarser;
    }

    /** Returns the marks of a map, areas and lines. */
    public static List<Mark> of(HeatMap map) {
        double coarser = map.cells().size() > MANY_SURFACES ? 3 : 1;
        HeatRegions regions = new HeatRegions(coarser);
        for (Map.Entry<HeatSurface, List<HeatCell>> entry : map.cells().entrySet()) {
            for (Region region : merged(entry.getKey(), entry.getValue())) {
                regions.add(entry.getKey(), region);
            }
        }
        return List.copyOf(regions.marks);
    }

    /** A convex area of one result. */
    private record Region(HeatText text, MarkColour colour, List<Vec3> corners) {}

    /** Joins cells to columns, then columns to rectangles; both come in order. */
    private static List<Region> merged(HeatSurface surface, List<HeatCell> cells) {
        List<Region> columns = new ArrayList<>();
        for (HeatCell cell : cells) {
            join(
                    surface,
                    columns,
                    new Region(cell.text(), cell.colour(), cell.mark().corners()),
                    1);
        }
        List<Region> areas = new ArrayList<>();
        for (Region column : columns) {
            join(surface, areas, column, 12);
        }
        return areas;
    }

    /** Adds an area, joined to one of the last ones if the two form a convex one. */
    private static void join(HeatSurface surface, List<Region> areas, Region added, int last) {
        for (int i = areas.size() - 1; i >= Math.max(0, areas.size() - last); i--) {
            Region other = areas.get(i);
            if (other.text() == added.text()) {
                List<Vec3> hull = hull(surface, other.corners(), added.corners());
                double excess = FacePieces.areaSquareMetres(hull)
                        - FacePieces.areaSquareMetres(other.corners())
                        - FacePieces.areaSquareMetres(added.corners());
                if (Math.abs(excess) < CONVEX) {
                    areas.set(i, new Region(other.text(), other.colour(), hull));
                    return;
                }
            }
        }
        areas.add(added);
    }

    /** Returns the convex hull in the surface's plane (Andrew 1979, monotone chain). */
    private static List<Vec3> hull(HeatSurface surface, List<Vec3> first, List<Vec3> second) {
        Vec3 right = surface.axes().right();
        Vec3 up = surface.axes().up();
        List<Vec3> all = new ArrayList<>(first);
        all.addAll(second);
        all.sort(Comparator.<Vec3>comparingDouble(p -> Math.rint(right.dot(p) * 1e6))
                .thenComparingDouble(p -> Math.rint(up.dot(p) * 1e6)));
        List<Vec3> hull = new ArrayList<>(chain(all, surface.normal()));
        Collections.reverse(all);
        hull.addAll(chain(all, surface.normal()));
        return hull;
    }

    /** Returns one half of the hull without its last point. */
    private static List<Vec3> chain(List<Vec3> sorted, Vec3 normal) {
        List<Vec3> chain = new ArrayList<>();
        for (Vec3 point : sorted) {
            while (chain.size() >= 2
                    && !turnsLeft(chain.get(chain.size() - 2), chain.get(chain.size() - 1), point, normal)) {
                chain.remove(chain.size() - 1);
            }
            chain.add(point);
        }
        chain.remove(chain.size() - 1);
        return chain;
    }

    private static boolean turnsLeft(Vec3 a, Vec3 b, Vec3 c, Vec3 normal) {
        return b.minus(a).cross(c.minus(b)).dot(normal) > 1e-9;
    }

    private void add(HeatSurface surface, Region region) {
        marks.add(new Mark.Polygon(region.corners(), region.colour(), Mark.Visibility.HIDDEN_BY_SURFACES));
        double spacing = coarser * (region.text() == HeatText.NOT_PORTALABLE ? WIDE_METRES : CLOSE_METRES);
        if (region.text() != HeatText.FITS) {
            hatch(region, surface.axes().right().plus(surface.axes().up()).scaled(Math.sqrt(0.5)), spacing);
        }
        if (region.text() != HeatText.FITS && region.text() != HeatText.SLIDES) {
            hatch(region, surface.axes().right().minus(surface.axes().up()).scaled(Math.sqrt(0.5)), spacing);
        }
    }

    /** Adds parallel lines across an area; those of neighbouring areas continue each other. */
    private void hatch(Region region, Vec3 across, double wishedMetres) {
        double least = Double.POSITIVE_INFINITY;
        double greatest = Double.NEGATIVE_INFINITY;
        for (Vec3 corner : region.corners()) {
            least = Math.min(least, across.dot(corner));
            greatest = Math.max(greatest, across.dot(corner));
        }
        double spacing = wishedMetres;
        while ((greatest - least) / spacing > MOST_LINES) {
            spacing *= 2;
        }
        for (double at = Math.ceil(least / spacing) * spacing; at < greatest; at += spacing) {
            line(region, across, at);
        }
    }

    private void line(Region region, Vec3 across, double at) {
        List<Vec3> ends = new ArrayList<>();
        List<Vec3> corners = region.corners();
        for (int i = 0; i < corners.size(); i++) {
            Vec3 from = corners.get(i);
            Vec3 to = corners.get((i + 1) % corners.size());
            double a = across.dot(from) - at;
            double b = across.dot(to) - at;
            if (a < 0 != b < 0) {
                ends.add(from.addScaled(a / (a - b), to.minus(from)));
            }
        }
        if (ends.size() == 2) {
            marks.add(new Mark.Stroke(ends.get(0), ends.get(1), region.colour()));
        }
    }
}

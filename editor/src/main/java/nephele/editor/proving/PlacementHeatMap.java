package nephele.editor.proving;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.engine.level.Level;
import nephele.engine.level.PortalGun;
import nephele.engine.level.PortalShape;
import nephele.engine.level.layout.BrushIndex;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.Gun;
import nephele.engine.portal.placement.Placement;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.PlacementSurfaces;
import nephele.engine.portal.placement.ShotRay;

/**
 * Computes where the gun's portal fits, slides or is refused: a shot straight at each cell of a grid on every surface
 * that takes portals, with the level's fixed portals open; a surface that takes none is one cell. A level without a gun
 * is shown for the default one. Bodies bar nothing. Used once, by one thread.
 */
public final class PlacementHeatMap {
    /** Distance before the surface from which a cell is shot at; something nearer hides it. */
    private static final double EYE_METRES = 0.02;

    /** Distance of the cells before their surface, so that it does not hide them. */
    private static final double LIFT_METRES = 5e-3;

    /** Slide up to which a portal is where it was aimed. */
    public static final double AIMED_METRES = 1e-6;

    /** What the engine tolerates beside the portal itself. */
    private static final double REACH_METRES = 0.25;

    /** The greatest number of doublings of the cells' size; the remaining excess is left out. */
    private static final int MOST_DOUBLINGS = 20;

    /** The gun of a level that has none. */
    public static final PortalGun DEFAULT_GUN = new PortalGun(1.2, 2.1, PortalShape.ARCH, 500);

    private static final double SPACING_METRES = 0.25;
    private static final int MOST_CELLS = 40_000;

    private final double yawRadians;
    private final int mostCells;
    private final List<HeatSurface> surfaces;
    private final BrushIndex solids;
    private final Placement placement;
    private final List<Portal> fixed;
    private final double spacing;
    private final PlacedLevel placed;
    private final Map<HeatSurface, List<HeatCell>> kept;
    private final Map<HeatSurface, List<HeatCell>> computed = new LinkedHashMap<>();
    private volatile int finished;

    /**
     * Prepares the map of a level, with cells of a quarter of a metre, seen by a shooter who faces −z.
     *
     * @param before a map of the level before an edit, made in the same way, or {@code null}
     */
    PlacementHeatMap(PlacedLevel placed, HeatMap before) {
        this(placed, SPACING_METRES, 0, MOST_CELLS, before);
    }

    /**
     * Prepares the map of a level; the shots are made by {@link #compute}.
     *
     * @param spacingMetres side of its cells; coarser where the level would have more than {@code mostCells}
     * @param yawRadians direction that the shooter faces over floors and under ceilings; 0 looks along −z, positive to the
     *     left
     * @param before a map of the level before an edit, made in the same way, or {@code null}
     */
    PlacementHeatMap(PlacedLevel placed, double spacingMetres, double yawRadians, int mostCells, HeatMap before) {
        this.yawRadians = yawRadians;
        this.mostCells = mostCells;
        this.placed = placed;
        Level level = placed.level();
        surfaces = HeatSurface.all(placed.statics());
        solids = new BrushIndex(placed.statics());
        PortalGun authored = level.portalGun() == null ? DEFAULT_GUN : level.portalGun();
        Gun gun = Gun.of(authored);
        placement = new Placement(PlacementSurfaces.of(placed.statics()), gun);
        fixed = level.portals().stream().map(Portal::of).toList();
        spacing = spacing(spacingMetres);
        double reach = REACH_METRES + gun.slideMetres() + authored.widthMetres() + authored.heightMetres();
        kept = before != null && before.spacingMetres() == spacing ? before.kept(placed, surfaces, reach) : Map.of();
    }

    /** Returns the map after {@link #compute}. */
    public HeatMap map() {
        return new HeatMap(placed, spacing, computed);
    }

    /** Returns the fraction of the surfaces that have been dealt with, 0–1. */
    public double done() {
        return surfaces.isEmpty() ? 1 : (double) finished / surfaces.size();
    }

    /** Returns the number of surfaces that an edit has left as they were. */
    public int keptSurfaces() {
        return kept.size();
    }

    /** Returns the side of the cells, in metres. */
    public double spacingMetres() {
        return spacing;
    }

    private double spacing(double wishedMetres) {
        double side = wishedMetres;
        for (int i = 0; i < MOST_DOUBLINGS && cells(side) > mostCells; i++) {
            side *= 2;
        }
        return side;
    }

    private long cells(double side) {
        return surfaces.stream()
                .mapToLong(surface -> surface.portalable() ? surface.cells(side) : 1)
                .sum();
    }

    /**
     * Computes the cells, surface by surface, at most as many as are permitted.
     *
     * @param isCancelled asked between cells; an interrupt of the thread cancels, too
     * @param progress called after each surface
     * @return false if cancelled
     */
    public boolean compute(BooleanSupplier isCancelled, Runnable progress) {
        int left = mostCells;
        for (HeatSurface surface : surfaces) {
            List<HeatCell> its = kept.get(surface);
            if (its == null) {
                its = cells(surface, left, isCancelled);
            }
            if (its == null) {
                return false;
            }
            computed.put(surface, its);
            finished++;
            left -= its.size();
            progress.run();
        }
        return true;
    }

    /** Returns {@code null} if cancelled. */
    private List<HeatCell> cells(HeatSurface surface, int most, BooleanSupplier isCancelled) {
        List<HeatCell> cells = new ArrayList<>();
        Basis view = surface.view(yawRadians);
        for (List<Vec3> piece : surface.portalable() ? surface.pieces(spacing) : List.of(surface.corners())) {
            if (isCancelled.getAsBoolean() || Thread.currentThread().isInterrupted()) {
                return null;
            }
            HeatCell cell = cells.size() < most ? cell(surface, piece, view) : null;
            if (cell != null) {
                cells.add(cell);
            }
        }
        return List.copyOf(cells);
    }

    /** Returns {@code null} for a cell that a solid hides. */
    private HeatCell cell(HeatSurface surface, List<Vec3> piece, Basis view) {
        Vec3 aim = middle(piece);
        if (!surface.portalable()) {
            return cell(surface, piece, aim, HeatText.NOT_PORTALABLE, 0);
        }
        Vec3 eye = aim.addScaled(EYE_METRES, surface.normal());
        if (solids.holding(eye, 0) >= 0) {
            return null;
        }
        PlacementResult result = placement.place("heat", new ShotRay(eye, view), fixed, Obstacles.NONE);
        if (result instanceof PlacementResult.Fits fits) {
            double slide = fits.slideMetres() > AIMED_METRES ? fits.slideMetres() : 0;
            return cell(surface, piece, aim, slide > 0 ? HeatText.SLIDES : HeatText.FITS, slide);
        }
        PlacementResult.Refused refused = (PlacementResult.Refused) result;
        return cell(surface, piece, aim, HeatText.of(refused.reason()), refused.unevenMetres());
    }

    private static HeatCell cell(HeatSurface surface, List<Vec3> piece, Vec3 aim, HeatText text, double metres) {
        MarkColour colour = text == HeatText.FITS
                ? MarkColour.ALLOWED
                : text == HeatText.SLIDES ? MarkColour.SLIDES : MarkColour.REFUSED;
        List<Vec3> lifted = piece.stream()
                .map(corner -> corner.addScaled(LIFT_METRES, surface.normal()))
                .toList();
        return new HeatCell(new Mark.Polygon(lifted, colour, Mark.Visibility.HIDDEN_BY_SURFACES), aim, text, metres);
    }

    private static Vec3 middle(List<Vec3> polygon) {
        Vec3 sum = Vec3.ZERO;
        for (Vec3 corner : polygon) {
            sum = sum.plus(corner);
        }
        return sum.scaled(1.0 / polygon.size());
    }
}

package nephele.engine.portal.ground;

import java.util.List;
import java.util.function.UnaryOperator;
import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;

/**
 * The place of a portal over a point of a terrain. Its plane is parallel to the one nearest to the ground under
 * aperture and rim, and moved out along its normal over the highest ground there, so that no ground stands in front of
 * the portal. It depends only on the point, the aperture and its upright, and is continuous in them.
 *
 * @param unevenMetres greatest deviation of the ground from the nearest plane; a lower bound of it for ground that takes
 *     no portal
 */
public record GroundSeat(Portal portal, double unevenMetres) {
    /** Greatest deviation over the aperture with which ground takes a portal. */
    public static final double MOST_UNEVEN_METRES = 0.01;

    /** The step of a portal that is not on ground. */
    public static final double NO_GROUND = -1;

    /** Allowance for rounding and for portals that follow flat ground by least squares. */
    private static final double STEP_TOLERANCE_METRES = 1.1e-3;

    private static final double MOST_STEP_METRES = 2 * MOST_UNEVEN_METRES + STEP_TOLERANCE_METRES;

    private static final double ROUNDING_METRES = 1e-6;
    private static final Vec3 UP = new Vec3(0, 1, 0);

    /** Distance from the border, in cells, at which rounding leaves a place on the field. */
    private static final double BORDER_CELLS = 1e-6;

    /** Deviation of a few points, in greatest ones, that does not follow from differing axes. */
    private static final double CERTAIN = 1.1;

    private static final int MOST_TURNS = 4;
    private static final double SAME_SLOPE = 1e-6;

    /** Deviation that no small turn of the first plane can mend, in greatest ones. */
    private static final double HOPELESS = 2;

    /**
     * Finds the place.
     *
     * @param on a point of the terrain; the portal's centre is in front of it
     * @param upright returns the portal's up direction for its normal
     */
    public static GroundSeat over(
            HeightField field, Vec3 on, String id, Aperture aperture, UnaryOperator<Vec3> upright) {
        Portal portal = facing(id, on, startNormal(field, on, aperture), aperture, upright);
        for (int turn = 0; turn < MOST_TURNS; turn++) {
            ApertureGround ground = ApertureGround.under(field, portal);
            double enough = turn == 0 ? HOPELESS * MOST_UNEVEN_METRES : MOST_UNEVEN_METRES + ROUNDING_METRES;
            ground.fit(enough);
            if (ground.atLeastMetres() > enough) {
                return new GroundSeat(portal, ground.atLeastMetres());
            }
            if (Math.abs(ground.slopeX()) + Math.abs(ground.slopeY()) < SAME_SLOPE) {
                break;
            }
            Basis axes = portal.frame();
            Vec3 tilt = Directions.combined(axes.right(), -ground.slopeX(), axes.up(), -ground.slopeY());
            portal = facing(id, on, axes.back().addScaled(1, tilt), aperture, upright);
        }
        return raised(field, portal);
    }

    private static GroundSeat raised(HeightField field, Portal portal) {
        ApertureGround ground = ApertureGround.under(field, portal);
        if (ground.size() == 0) {
            return new GroundSeat(portal, Double.POSITIVE_INFINITY);
        }
        double highest = ground.highest();
        Vec3 centre = portal.world(0, 0, highest);
        return new GroundSeat(
                new Portal(portal.id(), centre, portal.frame(), portal.aperture()), (highest - ground.lowest()) / 2);
    }

    private static Portal facing(String id, Vec3 on, Vec3 direction, Aperture aperture, UnaryOperator<Vec3> upright) {
        Vec3 normal = Directions.unit(direction);
        Vec3 up = upright.apply(normal);
        return new Portal(id, on, new Basis(Directions.unit(up.cross(normal)), up, normal), aperture);
    }

    /** Returns the normal of the slopes over the aperture's size; it changes continuously with the point. */
    private static Vec3 startNormal(HeightField field, Vec3 on, Aperture aperture) {
        double reach = Math.min(aperture.widthMetres(), aperture.heightMetres()) / 2;
        double x = withinX(field, on.x());
        double z = withinZ(field, on.z());
        double west = withinX(field, on.x() - reach);
        double east = withinX(field, on.x() + reach);
        double north = withinZ(field, on.z() - reach);
        double south = withinZ(field, on.z() + reach);
        double alongX = (HeightFieldSurface.y(field, east, z) - HeightFieldSurface.y(field, west, z)) / (east - west);
        double alongZ =
                (HeightFieldSurface.y(field, x, south) - HeightFieldSurface.y(field, x, north)) / (south - north);
        return Double.isFinite(alongX + alongZ) ? new Vec3(-alongX, 1, -alongZ) : UP;
    }

    private static double withinX(HeightField field, double x) {
        double margin = BORDER_CELLS * field.cellX();
        return Math.max(field.x(0) + margin, Math.min(field.x(field.cellColumns()) - margin, x));
    }

    private static double withinZ(HeightField field, double z) {
        double margin = BORDER_CELLS * field.cellZ();
        return Math.max(field.z(0) + margin, Math.min(field.z(field.cellRows()) - margin, z));
    }

    /**
     * Returns false if a few points of the ground under a portal show that there is none near it: quick, for places that
     * need not be tried.
     *
     * @param near a portal over the point, with about the right axes
     */
    public static boolean isPossible(HeightField field, Portal near) {
        ApertureGround few = ApertureGround.sampled(field, near);
        return few.size() < 4
                || few.fit(MOST_UNEVEN_METRES * CERTAIN).atLeastMetres() <= MOST_UNEVEN_METRES * CERTAIN;
    }

    /** Returns the greatest deviation from the nearest plane also for ground that takes no portal. */
    public double measuredUneven(HeightField field) {
        return isEven()
                ? unevenMetres
                : ApertureGround.under(field, portal).fit(Double.POSITIVE_INFINITY).greatestMetres();
    }

    /** Returns true if the ground takes a portal here. */
    public boolean isEven() {
        return unevenMetres <= MOST_UNEVEN_METRES + ROUNDING_METRES;
    }

    /**
     * Returns the greatest distance in metres of the ground under aperture and rim from the portal's plane, or {@link
     * #NO_GROUND} if the portal does not lie on one of the terrains.
     */
    public static double stepMetres(List<HeightField> terrains, Portal portal) {
        for (HeightField field : terrains) {
            ApertureGround ground = ApertureGround.under(field, portal);
            if (ground.size() > 0 && ground.highest() <= STEP_TOLERANCE_METRES && ground.lowest() >= -MOST_STEP_METRES) {
                return Math.max(0, -ground.lowest());
            }
        }
        return NO_GROUND;
    }
}

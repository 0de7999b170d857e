package nephele.engine.portal.placement;

import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.portal.Portal;

/**
 * Slides the portal of a shot at a wall down to the floor before it, so that it can be walked into. Rays down
 * along the wall, before the portal's lower edge, find the floor: what is fixed, or where there is none, the bodies.
 */
final class FloorDrop {
    private static final double ROUNDING_METRES = 1e-9;

    /** A lower edge this near the floor is on it. */
    private static final double ON_FLOOR_METRES = 1e-3;

    /** Greatest height of a lower edge above the floor that is better than none: a skirting board, a floor that falls. */
    private static final double MOST_SILL_METRES = 0.1;

    /** Height over the lower edge from which rays start, so that they find floors that rise from the wall. */
    private static final double OVER_METRES = 0.2;

    /** Distances of the rays from the wall: the narrowest ledge to stand on, and the middle of a player at the wall. */
    private static final double[] BEFORE_METRES = {0.08, 0.3};

    /** Places of the rays along the lower edge, in half widths; the first has to find a floor. */
    private static final double[] ALONG = {0, -0.45, 0.45, -0.95, 0.95};

    /** Distance of further rays that find how steep a body is. */
    private static final double SLOPE_METRES = 0.02;

    private final PlacementSurfaces surfaces;
    private final ShotAids aids;
    private final RayHit hit = new RayHit();

    FloorDrop(PlacementSurfaces surfaces, ShotAids aids) {
        this.surfaces = surfaces;
        this.aids = aids;
    }

    /** Returns true if portals on a surface slide down: it is neither a floor nor nearly a ceiling. */
    boolean isFor(Vec3 normal) {
        return aids.dropMetres() > 0 && Math.abs(normal.y()) < aids.leastFloorY();
    }

    /**
     * Returns the portal on the floor under the aimed one or under the nearest one that fits; the nearest result if
     * there is no floor or no place on it.
     *
     * @param aimed the portal over the aimed point
     * @param nearest where it fits
     * @param fit returns the result of an aim at another point of the wall
     */
    PlacementResult lowered(
            Portal aimed, PlacementResult nearest, Function<Vec3, PlacementResult> fit, MovingSurfaces moving) {
        Portal fitting = nearest instanceof PlacementResult.Fits fits ? fits.portal() : null;
        double sill = fitting == null ? Double.POSITIVE_INFINITY : sillMetres(fitting, moving);
        if (sill <= ON_FLOOR_METRES) {
            return nearest;
        }
        double most = Double.isNaN(sill) ? MOST_SILL_METRES : Math.min(sill - ON_FLOOR_METRES, MOST_SILL_METRES);
        Portal low = onFloor(aimed, most, fit, moving);
        if (low == null && fitting != null) {
            low = onFloor(fitting, most, fit, moving);
        }
        return low == null
                ? nearest
                : new PlacementResult.Fits(
                        low, low.centre().minus(aimed.centre()).length());
    }

    /**
     * Returns the portal that fits on the floor under another one.
     *
     * @param most greatest height of its lower edge above the floor
     * @return {@code null} if there is none
     */
    private Portal onFloor(Portal over, double most, Function<Vec3, PlacementResult> fit, MovingSurfaces moving) {
        double sill = sillMetres(over, moving);
        if (Double.isNaN(sill) || sill > reach()) {
            return null;
        }
        Portal low = fitted(over, sill, fit);
        double left = low == null ? Double.NaN : sillMetres(low, moving);
        if (left > ON_FLOOR_METRES) {
            // It has slid along a wall whose floor is not level.
            low = fitted(low, left, fit);
            left = low == null ? Double.NaN : sillMetres(low, moving);
        }
        return left <= most ? low : null;
    }

    /** Returns the greatest height above a floor from which a portal slides down. */
    private double reach() {
        return aids.dropMetres() + ROUNDING_METRES;
    }

    private static Portal fitted(Portal over, double sill, Function<Vec3, PlacementResult> fit) {
        Vec3 up = over.frame().up();
        PlacementResult placed = fit.apply(over.centre().addScaled(-sill / up.y(), up));
        return placed instanceof PlacementResult.Fits fits ? fits.portal() : null;
    }

    /** Returns the height of a portal's lower edge above the highest floor under it; NaN without one in reach. */
    private double sillMetres(Portal portal, MovingSurfaces moving) {
        double reach = OVER_METRES + reach() / portal.frame().up().y();
        double sill = sillMetres(portal, down -> fixed(down, reach));
        return Double.isNaN(sill) ? sillMetres(portal, down -> body(down, reach, moving)) : sill;
    }

    /** @param floor returns the height of the walkable surface that a ray of unit direction hits; NaN for none */
    private static double sillMetres(Portal portal, ToDoubleFunction<Ray> floor) {
        Vec3 down = portal.frame().up().negated();
        double half = portal.aperture().widthMetres() / 2;
        double lower = -portal.aperture().heightMetres() / 2;
        double highest = Double.NaN;
        for (double along : ALONG) {
            for (double before : BEFORE_METRES) {
                Ray ray = Ray.of(portal.world(along * half, lower + OVER_METRES, before), down);
                double y = floor.applyAsDouble(ray);
                highest = Double.isNaN(highest) || y > highest ? y : highest;
            }
            if (Double.isNaN(highest)) {
                return Double.NaN;
            }
        }
        return portal.world(0, lower, 0).y() - highest;
    }

    private double fixed(Ray down, double reach) {
        boolean isFloor = surfaces.first(down, hit)
                && hit.distance() <= reach
                && surfaces.upwards(down, hit.item()) >= aids.leastFloorY();
        return isFloor ? down.at(hit.distance()).y() : Double.NaN;
    }

    private double body(Ray down, double reach, MovingSurfaces moving) {
        double y = bodyY(down, Vec3.ZERO, reach, moving);
        double x = bodyY(down, new Vec3(SLOPE_METRES, 0, 0), reach, moving) - y;
        double z = bodyY(down, new Vec3(0, 0, SLOPE_METRES), reach, moving) - y;
        double upwards = SLOPE_METRES / Math.sqrt(SLOPE_METRES * SLOPE_METRES + x * x + z * z);
        return upwards >= aids.leastFloorY() ? y : Double.NaN;
    }

    private static double bodyY(Ray down, Vec3 aside, double reach, MovingSurfaces moving) {
        Vec3 start = down.at(0).plus(aside);
        Vec3 direction = new Vec3(down.directionX(), down.directionY(), down.directionZ());
        double depth = moving.distance(start, direction, reach);
        return depth <= reach ? start.y() + depth * direction.y() : Double.NaN;
    }
}

package nephele.engine.portal.placement;

import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Brush;
import nephele.engine.level.PortalShape;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.PlacementResult.Refusal;

/** Boxes around a wall in the plane z = 0 that faces +z, and shots at it along −z. */
final class Walls {
    static final Gun ARCH = gun(PortalShape.ARCH, 1.2, 2.1);

    private final List<Brush> solids = new ArrayList<>();
    private final List<SurfacePolygon> sheets = new ArrayList<>();
    private Vec3 shift = Vec3.ZERO;
    private ShotAids aids = ShotAids.NONE;
    private Obstacles moving = Obstacles.NONE;

    static Gun gun(PortalShape shape, double width, double height) {
        return new Gun(Aperture.of(shape, width, height), 200, 0.75 / 2.1 * height);
    }

    /** Shifts all later shapes from the origin. */
    Walls shifted(Vec3 by) {
        shift = by;
        return this;
    }

    Walls box(double x0, double y0, double z0, double x1, double y1, double z1, boolean portalable) {
        Vec3 centre = new Vec3((x0 + x1) / 2 + shift.x(), (y0 + y1) / 2 + shift.y(), (z0 + z1) / 2 + shift.z());
        Vec3 size = new Vec3(x1 - x0, y1 - y0, z1 - z0);
        solids.add(Brush.of(
                new Solid.Box("s" + solids.size(), null, portalable, TextureMapping.WORLD, centre, size, Map.of())));
        return this;
    }

    Walls solid(Solid solid) {
        solids.add(Brush.of(solid));
        return this;
    }

    Walls sheet(Vec3... corners) {
        sheets.add(SurfacePolygon.of(List.of(corners), false));
        return this;
    }

    /** Aids the shots. */
    Walls with(ShotAids helping) {
        aids = helping;
        return this;
    }

    Walls with(Obstacles bodies) {
        moving = bodies;
        return this;
    }

    /** Adds a piece of the wall. */
    Walls wall(double x0, double y0, double x1, double y1) {
        return box(x0, y0, -1, x1, y1, 0, true);
    }

    Walls without(double x0, double y0, double x1, double y1) {
        return box(x0, y0, -1, x1, y1, 0, false);
    }

    Walls triangle(double... xy) {
        sheets.add(SurfacePolygon.of(List.of(at(xy, 0), at(xy, 1), at(xy, 2)), true));
        return this;
    }

    private Vec3 at(double[] xy, int corner) {
        return new Vec3(xy[2 * corner] + shift.x(), xy[2 * corner + 1] + shift.y(), shift.z());
    }

    PlacementSurfaces surfaces() {
        return PlacementSurfaces.of(solids, sheets);
    }

    PlacementResult shoot(Gun gun, double x, double y, Portal... others) {
        ShotRay aim = new ShotRay(new Vec3(x + shift.x(), y + shift.y(), 5 + shift.z()), Basis.WORLD);
        return new Placement(surfaces(), gun).with(aids).place("p", aim, List.of(others), moving);
    }

    static Portal fits(PlacementResult placed) {
        return assertInstanceOf(PlacementResult.Fits.class, placed).portal();
    }

    static Refusal refused(PlacementResult placed) {
        return assertInstanceOf(PlacementResult.Refused.class, placed).reason();
    }
}

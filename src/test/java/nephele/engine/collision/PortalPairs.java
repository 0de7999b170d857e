package nephele.engine.collision;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;

/** Places with portals for tests, at any distance from the origin. */
record PortalPairs(CollisionWorld statics, Portals portals) {
    private static final Vec3 UP = new Vec3(0, 1, 0);

    static Portal portal(String id, Vec3 centre, Vec3 normal, Vec3 up, PortalShape shape) {
        return new Portal(id, centre, Portal.facing(normal, up), Aperture.of(shape, 1.2, 2.1));
    }

    static PortalPairs linked(CollisionWorld statics, Portal a, Portal b) {
        return new PortalPairs(statics, new Portals(List.of(a, b), List.of(1, 0)));
    }

    /** Returns boxes from their lower and upper corners, shifted to the origin. */
    static CollisionWorld boxes(Vec3 origin, double[]... corners) {
        List<Collider> solids = new ArrayList<>();
        for (double[] c : corners) {
            Aabb box = new Aabb(
                    origin.x() + c[0],
                    origin.y() + c[1],
                    origin.z() + c[2],
                    origin.x() + c[3],
                    origin.y() + c[4],
                    origin.z() + c[5]);
            solids.add(new Collider("box" + solids.size(), ConvexPolyhedron.box(box)));
        }
        return new CollisionWorld(solids);
    }

    /** Returns a room of 10 × 4 × 10 m with walls 0.2 m thick, with solids in it and behind its walls. */
    private static CollisionWorld room(Vec3 origin) {
        return boxes(
                origin,
                new double[] {-8, -0.2, -8, 8, 0, 8},
                new double[] {-8, 4, -8, 8, 4.2, 8},
                new double[] {-5, 0, -5.2, 5, 4, -5},
                new double[] {-5, 0, 5, 5, 4, 5.2},
                new double[] {-5.2, 0, -5.2, -5, 4, 5.2},
                new double[] {5, 0, -5.2, 5.2, 4, 5.2},
                new double[] {1, 0, -4, 1.4, 0.5, -3.5},
                new double[] {-4.5, 0, 0.9, -3, 1, 1.4},
                new double[] {-1, 0, -7, 1, 1, -6});
    }

    private static Vec3 at(Vec3 origin, double x, double y, double z) {
        return new Vec3(origin.x() + x, origin.y() + y, origin.z() + z);
    }

    static PortalPairs of(String kind, Vec3 o) {
        Vec3 south = new Vec3(0, 0, 1);
        Vec3 east = new Vec3(1, 0, 0);
        Vec3 north = new Vec3(0, 0, -1);
        PortalShape arch = PortalShape.ARCH;
        return switch (kind) {
            case "walls" ->
                linked(
                        room(o),
                        portal("a", at(o, 0, 1.05, -5), south, UP, arch),
                        portal("b", at(o, -5, 1.05, 0), east, UP, arch));
            case "floor and wall" ->
                linked(
                        room(o),
                        portal("a", at(o, 0, 1.5, -5), south, UP, PortalShape.ELLIPSE),
                        portal("b", at(o, -2, 0, 2), UP, east, PortalShape.ELLIPSE));
            case "floor and ceiling" ->
                linked(
                        room(o),
                        portal("a", at(o, 1, 4, 1), new Vec3(0, -1, 0), east, PortalShape.RECTANGLE),
                        portal("b", at(o, -2, 0, 2), UP, south, PortalShape.RECTANGLE));
            case "corner" ->
                linked(
                        room(o),
                        portal("a", at(o, -4.4, 1.05, -5), south, UP, PortalShape.RECTANGLE),
                        portal("b", at(o, -5, 1.05, -4.4), east, UP, PortalShape.RECTANGLE));
            case "side by side" ->
                linked(
                        room(o),
                        portal("a", at(o, 0, 1.05, -5), south, UP, arch),
                        portal("b", at(o, 1.2, 1.05, -5), south, UP, arch));
            case "facing" ->
                linked(
                        boxes(o, new double[] {-3, -1, -5, 3, 0, 5}, new double[] {-3, 0, -2, 3, 4, 0}, new double[] {
                            -3, 0, 0.2, 3, 4, 2
                        }),
                        portal("a", at(o, 0, 1.05, 0), south, UP, arch),
                        portal("b", at(o, 0.2, 1.05, 0.2), north, UP, arch));
            case "slanted" -> slanted(o);
            default -> throw new IllegalArgumentException(kind);
        };
    }

    /** Returns one portal in a wall, and the other in a plane inclined by 40° over a narrow lane. */
    private static PortalPairs slanted(Vec3 o) {
        double sin = StrictMath.sin(Math.toRadians(40));
        double cos = StrictMath.cos(Math.toRadians(40));
        Vec3 normal = new Vec3(0, sin, cos);
        List<Collider> solids = new ArrayList<>();
        CollisionWorld room = room(o);
        for (int i = 0; i < room.size(); i++) {
            solids.add(room.collider(i));
        }
        Portal a = portal("a", at(o, 2, 1.2, -5), new Vec3(0, 0, 1), UP, PortalShape.ARCH);
        Portal b = portal("b", at(o, -2, 1.1, 2), normal, UP, PortalShape.ARCH);
        solids.add(new Collider("ramp", behind(b, 2, 2, 0.6)));
        CollisionWorld lane = boxes(o, new double[] {-2.8, 0, 1, -2.7, 3, 5}, new double[] {-1.3, 0, 1, -1.2, 3, 5});
        solids.add(lane.collider(0));
        solids.add(lane.collider(1));
        return linked(new CollisionWorld(solids), a, b);
    }

    private static ConvexPolyhedron behind(Portal portal, double x, double y, double depth) {
        Vec3 r = portal.frame().right();
        Vec3 u = portal.frame().up();
        return ConvexPolyhedron.fromPlanes(List.of(
                Plane.through(portal.normal(), portal.centre()),
                Plane.through(portal.normal().negated(), portal.world(0, 0, -depth)),
                Plane.through(r, portal.world(x, 0, 0)),
                Plane.through(r.negated(), portal.world(-x, 0, 0)),
                Plane.through(u, portal.world(0, y, 0)),
                Plane.through(u.negated(), portal.world(0, -y, 0))));
    }
}

package nephele.engine.level;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.math.Vec3;

/** A level of boxes with portals, a gun and bodies, built by a test; its name is "room". */
public final class RoomLevel {
    private final List<Solid> solids = new ArrayList<>();
    private final List<PortalSpec> portals = new ArrayList<>();
    private final List<Body> bodies = new ArrayList<>();
    private PlayerStart start = new PlayerStart(Vec3.ZERO, 0, 0);
    private PortalGun gun;

    /**
     * Returns a hall of 16 m by 16 m, 6 m high, all of it portalable: z = −8 is the wall ahead, x = −8 the one to the
     * left.
     */
    public static RoomLevel hall() {
        return new RoomLevel()
                .box(-8, -1, -8, 8, 0, 8)
                .box(-8, 6, -8, 8, 7, 8)
                .box(-9, -1, -9, -8, 7, 9)
                .box(8, -1, -9, 9, 7, 9)
                .box(-9, -1, -9, 9, 7, -8)
                .box(-9, -1, 8, 9, 7, 9);
    }

    /** Adds a box by its lower and upper corner. */
    public RoomLevel box(double x0, double y0, double z0, double x1, double y1, double z1) {
        return box(x0, y0, z0, x1, y1, z1, true);
    }

    public RoomLevel box(double x0, double y0, double z0, double x1, double y1, double z1, boolean portalable) {
        Vec3 centre = new Vec3((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2);
        Vec3 size = new Vec3(x1 - x0, y1 - y0, z1 - z0);
        solids.add(new Solid.Box("box" + solids.size(), null, portalable, null, centre, size, Map.of()));
        return this;
    }

    public RoomLevel gun() {
        gun = new PortalGun(1.2, 2.1, PortalShape.ARCH, 500);
        return this;
    }

    /** Adds two fixed portals of 1.2 m × 2.1 m that lead to each other. */
    public RoomLevel pair(Vec3 centreA, Vec3 normalA, Vec3 centreB, Vec3 normalB) {
        String a = "p" + portals.size();
        String b = "p" + (portals.size() + 1);
        portals.add(portal(a, b, centreA, normalA));
        portals.add(portal(b, a, centreB, normalB));
        return this;
    }

    private static PortalSpec portal(String id, String linkedTo, Vec3 centre, Vec3 normal) {
        Vec3 up = Math.abs(normal.y()) > 0.9 ? new Vec3(0, 0, -1) : new Vec3(0, 1, 0);
        return new PortalSpec(id, linkedTo, centre, normal, up, 1.2, 2.1, PortalShape.ARCH);
    }

    public RoomLevel cube(Vec3 centre, double edge, double kilograms) {
        Vec3 size = new Vec3(edge, edge, edge);
        bodies.add(new Body.Box("cube" + bodies.size(), centre, size, kilograms, null, 0.6, 0));
        return this;
    }

    public RoomLevel body(Body body) {
        bodies.add(body);
        return this;
    }

    public RoomLevel startAt(double x, double y, double z, double yawDegrees, double pitchDegrees) {
        start = new PlayerStart(new Vec3(x, y, z), yawDegrees, pitchDegrees);
        return this;
    }

    public Level level() {
        var environment = new Environment(null, null, null, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());
        return Level.of("room", "", environment, List.of())
                .with(start, gun)
                .with(List.of(), List.copyOf(solids), List.copyOf(bodies))
                .withPortals(List.copyOf(portals));
    }
}

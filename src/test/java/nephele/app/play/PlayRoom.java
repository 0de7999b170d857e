package nephele.app.play;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Body;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalGun;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Solid;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;
import nephele.engine.sim.PlayerInput;
import nephele.engine.sim.SimSettings;

/** A level built by a test, and a walk in it whose input the test gives. */
final class PlayRoom {
    private final List<Solid> solids = new ArrayList<>();
    private final List<PortalSpec> portals = new ArrayList<>();
    private final List<Body> bodies = new ArrayList<>();
    private PortalGun gun;
    private PlayerStart start = new PlayerStart(Vec3.ZERO, 0, 0);
    private PlayerInput hands = PlayerInput.NONE;
    private Walk walk;

    /** 16 m by 16 m, 6 m high: z = −8 is the wall ahead, x = −8 the one to the left. */
    static PlayRoom hall() {
        return new PlayRoom()
                .box(-8, -1, -8, 8, 0, 8)
                .box(-8, 6, -8, 8, 7, 8)
                .box(-9, -1, -9, -8, 7, 9)
                .box(8, -1, -9, 9, 7, 9)
                .box(-9, -1, -9, 9, 7, -8)
                .box(-9, -1, 8, 9, 7, 9);
    }

    PlayRoom box(double x0, double y0, double z0, double x1, double y1, double z1) {
        Vec3 centre = new Vec3((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2);
        Vec3 size = new Vec3(x1 - x0, y1 - y0, z1 - z0);
        solids.add(new Solid.Box("box" + solids.size(), null, true, null, centre, size, Map.of()));
        return this;
    }

    /** Two of 1.2 m × 2.1 m that lead to each other. */
    PlayRoom pair(Vec3 centreA, Vec3 normalA, Vec3 centreB, Vec3 normalB) {
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

    PlayRoom cube(Vec3 centre, double edge) {
        bodies.add(new Body.Box("cube" + bodies.size(), centre, new Vec3(edge, edge, edge), 5, null, 0.6, 0));
        return this;
    }

    PlayRoom gun() {
        gun = new PortalGun(1.2, 2.1, PortalShape.ARCH, 500);
        return this;
    }

    PlayRoom startAt(double x, double y, double z, double yawDegrees, double pitchDegrees) {
        start = new PlayerStart(new Vec3(x, y, z), yawDegrees, pitchDegrees);
        return this;
    }

    Level level() {
        var environment = new Environment(null, null, null, 0, ToneCurve.CLIP, null, List.of());
        return new Level(
                "room",
                "",
                environment,
                start,
                List.of(),
                List.of(),
                List.copyOf(solids),
                List.of(),
                List.copyOf(portals),
                List.of(),
                List.copyOf(bodies),
                gun);
    }

    Walk walk() {
        if (walk == null) {
            walk = new Walk(level(), new Walk.Beginning("room.json", SimSettings.DEFAULT, null), new TickInput() {
                @Override
                public PlayerInput next() {
                    return hands;
                }

                @Override
                public boolean isFinished() {
                    return false;
                }
            });
        }
        return walk;
    }

    /** From now on. */
    PlayRoom hold(PlayerInput held) {
        hands = held;
        return this;
    }

    PlayRoom ticks(int count) {
        for (int i = 0; i < count; i++) {
            walk().tick();
        }
        return this;
    }
}

package nephele.workshop.prove.portals;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Body;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Solid;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;

/**
 * A row of rooms with a doorway from each to the next, in two versions. In one the rooms are side by side with open
 * doors. In the other they are far apart, each rotated by a quarter turn from the one before, with a pair of portals in
 * the middle of each door. Both look the same from inside.
 */
public final class DoorwayRooms {
    /** The distance from a room's door to the next one. */
    public static final double PITCH_METRES = 4.2;

    private static final double HALF_WIDTH = 2.5;
    private static final double HEIGHT = 3.2;
    private static final double DEPTH = 4;
    private static final double HALF_WALL = 0.1;
    private static final double HALF_DOOR = 0.6;
    private static final double DOOR_HEIGHT = 2.1;
    /** The aperture extends into the wall by so much, so that the wall bounds the visible opening. */
    private static final double HIDDEN_EDGE = 0.05;

    private static final double THICKNESS = 0.3;
    private static final double APART = 60;
    private static final int COLOURS = 12;
    private static final double BESIDE_LINE = 0.15;
    private static final double BEHIND_DOOR = -1.2;
    private static final double CUBE = 0.5;

    /** A place of the cube on the floor, out of the way. */
    static final Vec3 CUBE_ASIDE = new Vec3(-1.6, CUBE / 2, -1);

    /** A place of the cube in front of the eye, to be carried. */
    static final Vec3 CUBE_AHEAD = new Vec3(BESIDE_LINE, 1.5, BEHIND_DOOR - 1.2);

    /** The connection from one room to the next. */
    public enum Doors {
        OPEN,
        PORTALS
    }

    private final int doors;
    private final Doors kind;
    private final List<Solid> solids = new ArrayList<>();
    private final List<PortalSpec> portals = new ArrayList<>();

    private DoorwayRooms(int doors, Doors kind) {
        this.doors = doors;
        this.kind = kind;
        for (int room = 0; room <= doors; room++) {
            room(room);
        }
    }

    /** Returns a level of {@code doors} + 1 rooms; the player starts in the first one, looking at its door. */
    public static Level level(int doors, Doors kind) {
        return level(doors, kind, CUBE_ASIDE);
    }

    /** Returns the same level with the cube in another place. */
    static Level level(int doors, Doors kind, Vec3 cubeCentre) {
        var rooms = new DoorwayRooms(doors, kind);
        var environment =
                new Environment(null, null, new Vec3(1, 1, 1), Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());
        var size = new Vec3(CUBE, CUBE, CUBE);
        var cube = new Body.Box("cube", cubeCentre, size, 5, "paint-7", 0.6, 0);
        return Level.of("doorways", "", environment, List.of())
                .with(new PlayerStart(new Vec3(BESIDE_LINE, 0, BEHIND_DOOR), 0, 0), null)
                .with(paints(), List.copyOf(rooms.solids), List.of(cube))
                .withPortals(List.copyOf(rooms.portals));
    }

    private static List<Material> paints() {
        List<Material> paints = new ArrayList<>();
        for (int i = 0; i < COLOURS; i++) {
            var colour = new Vec3(
                    0.15 + 0.7 * (i * 5 % COLOURS) / COLOURS,
                    0.15 + 0.7 * (i * 7 % COLOURS) / COLOURS,
                    0.15 + 0.7 * (i * 11 % COLOURS) / COLOURS);
            paints.add(new Material("paint-" + i, colour, null, null, null, null, Vec3.ZERO, 1));
        }
        return paints;
    }

    private void room(int room) {
        double front = -DEPTH - HALF_WALL;
        box(room, 0, new Vec3(-HALF_WIDTH, -THICKNESS, front), new Vec3(HALF_WIDTH, 0, HALF_WALL));
        box(room, 1, new Vec3(-HALF_WIDTH, HEIGHT, front), new Vec3(HALF_WIDTH, HEIGHT + THICKNESS, HALF_WALL));
        side(room, 2, -HALF_WIDTH - THICKNESS, -HALF_WIDTH);
        side(room, 3, HALF_WIDTH, HALF_WIDTH + THICKNESS);
        wall(room, 4, front, -DEPTH, room < doors);
        wall(room, 5, 0, HALF_WALL, room > 0);
        furniture(room);
        if (kind == Doors.PORTALS && room < doors) {
            door(room, "out", "in" + (room + 1), front, 1);
            backing(room, front - THICKNESS, front);
        }
        if (kind == Doors.PORTALS && room > 0) {
            door(room, "in", "out" + (room - 1), HALF_WALL, -1);
            backing(room, HALF_WALL, HALF_WALL + THICKNESS);
        }
    }

    private void side(int room, int colour, double from, double to) {
        double start = -DEPTH - HALF_WALL;
        double quarter = (DEPTH + 2 * HALF_WALL) / 4;
        for (int i = 0; i < 4; i++) {
            box(
                    room,
                    colour + 3 * i,
                    new Vec3(from, -THICKNESS, start + i * quarter),
                    new Vec3(to, HEIGHT + THICKNESS, start + (i + 1) * quarter));
        }
    }

    private void wall(int room, int colour, double from, double to, boolean hasDoor) {
        if (hasDoor) {
            box(room, colour, new Vec3(-HALF_WIDTH, 0, from), new Vec3(-HALF_DOOR, HEIGHT, to));
            box(room, colour + 1, new Vec3(HALF_DOOR, 0, from), new Vec3(HALF_WIDTH, HEIGHT, to));
            box(room, colour + 2, new Vec3(-HALF_DOOR, DOOR_HEIGHT, from), new Vec3(HALF_DOOR, HEIGHT, to));
        } else {
            box(room, colour, new Vec3(-HALF_WIDTH, 0, from), new Vec3(HALF_WIDTH, HEIGHT, to));
        }
    }

    private void furniture(int room) {
        for (int i = 0; i < 5; i++) {
            double side = (i + room) % 2 == 0 ? -1 : 1;
            double x = side * (HALF_WIDTH - 0.45 - 0.1 * i);
            double z = -0.5 - 0.7 * i;
            double top = 0.5 + 0.35 * ((i * 3 + room) % 5);
            box(room, 5 + 2 * i, new Vec3(x - 0.18, 0, z - 0.18), new Vec3(x + 0.18, top, z + 0.18));
        }
    }

    /** Adds a wall behind a portal. */
    private void backing(int room, double from, double to) {
        box(room, 9, new Vec3(-HALF_WIDTH, -THICKNESS, from), new Vec3(HALF_WIDTH, HEIGHT, to));
    }

    private void box(int room, int colour, Vec3 least, Vec3 most) {
        Vec3 a = placed(room, least);
        Vec3 b = placed(room, most);
        Vec3 centre = new Vec3((a.x() + b.x()) / 2, (a.y() + b.y()) / 2, (a.z() + b.z()) / 2);
        Vec3 size = new Vec3(Math.abs(b.x() - a.x()), Math.abs(b.y() - a.y()), Math.abs(b.z() - a.z()));
        String paint = "paint-" + Math.floorMod(colour + 5 * room, COLOURS);
        solids.add(new Solid.Box("s" + solids.size(), paint, false, null, centre, size, Map.of()));
    }

    private void door(int room, String id, String linkedTo, double depth, double facing) {
        double height = DOOR_HEIGHT + HIDDEN_EDGE;
        portals.add(new PortalSpec(
                id + room,
                linkedTo,
                placed(room, new Vec3(0, height / 2, depth)),
                turned(room, new Vec3(0, 0, facing)),
                new Vec3(0, 1, 0),
                2 * (HALF_DOOR + HIDDEN_EDGE),
                height,
                PortalShape.RECTANGLE));
    }

    /** Maps a point of the level with open doors to the given room of the level with portals. */
    static Vec3 twin(Vec3 open, int room) {
        return apart(room, new Vec3(open.x(), open.y(), open.z() + PITCH_METRES * room));
    }

    /**
     * Maps a point of a room's own space to the level. The room's back door is at z = 0 and its front door ahead of it.
     */
    private Vec3 placed(int room, Vec3 p) {
        return kind == Doors.OPEN ? new Vec3(p.x(), p.y(), p.z() - PITCH_METRES * room) : apart(room, p);
    }

    private static Vec3 apart(int room, Vec3 p) {
        Vec3 turned = turned(room, p);
        return new Vec3(turned.x() + APART * room, turned.y(), turned.z());
    }

    private static Vec3 turned(int room, Vec3 v) {
        return switch (room % 4) {
            case 0 -> v;
            case 1 -> new Vec3(v.z(), v.y(), -v.x());
            case 2 -> new Vec3(-v.x(), v.y(), -v.z());
            default -> new Vec3(-v.z(), v.y(), v.x());
        };
    }
}

package nephele.workshop.prove.bodies;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.level.Body;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;

/**
 * A closed room of 12 m by 12 m with axis-aligned boxes at rest. A family and a number give the same boxes as the
 * seeded piles with which other engines were measured.
 *
 * @param heightMetres from the floor, which is at 0, to the ceiling
 * @param bodies from the lowest to the top one
 */
public record BoxPile(String name, double heightMetres, List<Body.Box> bodies) {
    /** The ways to make a pile. */
    enum Family {
        /** One to four boxes of random edges and masses, one above the other with air between. */
        DROP,
        /** Twelve cubes of 40 cm, each 1, 2 or 3.16 times as heavy as the one below. */
        TOWER,
        /** A box of 1 t and 1 m on one small cube. */
        BIG;

        String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    static final double HALF_ROOM_METRES = 6;
    private static final double WALL_METRES = 1;
    private static final double FRICTION = 0.6;
    private static final double[] EDGES_METRES = {.001, .003, .01, .05, .2, .8, 2.5};
    private static final double[] MASSES_KILOGRAMS = {.001, .1, 5, 100, 1000};
    private static final double[] RATIOS = {1, 2, 3.16};
    private static final double[] SMALL_MASSES_KILOGRAMS = {.001, .01, .1, 1, 10};
    private static final double TOWER_EDGE_METRES = .4;

    static BoxPile of(Family family, int number) {
        Random random = new Random(7_919L * (number + 1) + 1_000_003L * family.ordinal());
        List<Body.Box> bodies =
                switch (family) {
                    case DROP -> drop(random);
                    case TOWER -> tower(random, RATIOS[number % RATIOS.length]);
                    case BIG -> bigOnSmall(random);
                };
        Body.Box top = bodies.get(bodies.size() - 1);
        double height = Math.max(6, top.centre().y() + top.size().y() / 2 + 2);
        return new BoxPile(family.word() + "-" + number, height, bodies);
    }

    private static List<Body.Box> drop(Random random) {
        List<Body.Box> bodies = new ArrayList<>();
        int count = 1 + random.nextInt(4);
        double y = .2;
        for (int i = 0; i < count; i++) {
            Vec3 size = new Vec3(pick(EDGES_METRES, random), pick(EDGES_METRES, random), pick(EDGES_METRES, random));
            y += size.y() / 2;
            Vec3 centre = new Vec3(jitter(random, .15), y, jitter(random, .15));
            bodies.add(box(i, centre, size, pick(MASSES_KILOGRAMS, random)));
            y += size.y() / 2 + .1 + .4 * random.nextDouble();
        }
        return bodies;
    }

    /** Makes a tower with a geometric mean mass of 10 kg. */
    private static List<Body.Box> tower(Random random, double ratio) {
        List<Body.Box> bodies = new ArrayList<>();
        double y = 0;
        for (int i = 0; i < 12; i++) {
            y += TOWER_EDGE_METRES / 2 + .002 * random.nextDouble();
            Vec3 centre = new Vec3(jitter(random, .01), y, jitter(random, .01));
            bodies.add(box(i, centre, cube(TOWER_EDGE_METRES), 10 * StrictMath.pow(ratio, i - 5.5)));
            y += TOWER_EDGE_METRES / 2;
        }
        return bodies;
    }

    /** Makes a big box with its centre of mass well above the small one's face. */
    private static List<Body.Box> bigOnSmall(Random random) {
        double edge = .05 + .35 * random.nextDouble();
        Body.Box small = box(0, new Vec3(0, edge / 2, 0), cube(edge), pick(SMALL_MASSES_KILOGRAMS, random));
        Vec3 centre = new Vec3(jitter(random, .2 * edge), edge + .5 + .001, jitter(random, .2 * edge));
        return List.of(small, box(1, centre, cube(1), 1000));
    }

    private static Body.Box box(int number, Vec3 centre, Vec3 size, double massKilograms) {
        return new Body.Box("b" + number, centre, size, massKilograms, null, FRICTION, 0);
    }

    private static Vec3 cube(double edge) {
        return new Vec3(edge, edge, edge);
    }

    private static double pick(double[] choices, Random random) {
        return choices[random.nextInt(choices.length)];
    }

    private static double jitter(Random random, double most) {
        return most * (2 * random.nextDouble() - 1);
    }

    /** Returns the room around the pile. */
    CollisionWorld room() {
        return closedRoom(HALF_ROOM_METRES, heightMetres, WALL_METRES);
    }

    /** Returns six slabs around a room; the middle of its floor is the origin. */
    public static CollisionWorld closedRoom(double half, double height, double wall) {
        double out = half + wall;
        return new CollisionWorld(List.of(
                slab("floor", new Aabb(-half, -wall, -half, half, 0, half)),
                slab("ceiling", new Aabb(-half, height, -half, half, height + wall, half)),
                slab("west", new Aabb(-out, -wall, -half, -half, height + wall, half)),
                slab("east", new Aabb(half, -wall, -half, out, height + wall, half)),
                slab("north", new Aabb(-out, -wall, -out, out, height + wall, -half)),
                slab("south", new Aabb(-out, -wall, half, out, height + wall, out))));
    }

    private static Collider slab(String id, Aabb box) {
        return new Collider(id, ConvexPolyhedron.box(box));
    }
}

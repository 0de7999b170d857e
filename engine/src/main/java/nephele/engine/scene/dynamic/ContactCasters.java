package nephele.engine.scene.dynamic;

import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.math.Frustum;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;
import nephele.engine.scene.ViewNode;
import nephele.engine.scene.ViewTree;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The spheres that stand for moving objects where these hide ambient light from what is near them, packed for shader
 * {@code include/contact.glsl}. One object serves all frames.
 */
public final class ContactCasters {
    /** The most spheres in a level: each costs about 1 % of a frame in llvmpipe. */
    private static final int MOST_SPHERES = 8;

    /** The most spheres of which a long body consists. */
    private static final int MOST_OF_BODY = 3;

    /** An object farther from all views than this many of its radii hides less than 1 %. */
    private static final double REACH_RADII = 10;

    /** Radius of a cube's sphere, in radii of the one with the same mean area of view: the share beside its faces is a cube's. */
    private static final double BOX_RADIUS = 0.87;

    /** Metres from the anchor at which an unused sphere is. */
    private static final double NOWHERE = 1e5;

    /** The spheres that stand for the character: its large parts and those near the ground; metres in the part's frame. */
    private record Ball(CharacterPart part, double radius, double middleY, double middleZ) {
        static final List<Ball> ALL = List.of(
                new Ball(CharacterPart.CHEST, 0.2, 0, 0.04),
                new Ball(CharacterPart.PELVIS, 0.2, -0.05, 0),
                new Ball(CharacterPart.LEFT_FOOT, 0.11, 0, -0.03),
                new Ball(CharacterPart.RIGHT_FOOT, 0.11, 0, -0.03));
    }

    private final DynamicObjects dynamicObjects;
    private final DynamicInstances copies;
    private final Vec3 anchor;
    /** Eight floats for each sphere: all spheres, then all owners. */
    private final float[] packed;

    private final int most;
    /** First instances of bodies, in descending order of their size in the view. */
    private final int[] bodies;

    private final double[] sizes;
    private int chosen;
    private int spheres;
    private final Quaterniond turn = new Quaterniond();
    private final Vector3d centre = new Vector3d();

    /**
     * Makes the spheres of a level.
     *
     * @param anchor world position that packed positions are relative to, metres
     * @param most the result of {@link #spheres}
     */
    public ContactCasters(DynamicObjects dynamicObjects, DynamicInstances copies, Vec3 anchor, int most) {
        this.dynamicObjects = dynamicObjects;
        this.copies = copies;
        this.anchor = anchor;
        this.most = most;
        packed = new float[8 * most];
        bodies = new int[most];
        sizes = new double[most];
    }

    /** Returns the number of spheres that a level's shaders are compiled for; 0 if nothing moves. */
    public static int spheres(Level level, CharacterPresence character) {
        int figure = character == CharacterPresence.NEVER ? 0 : level.observerStart() == null ? Ball.ALL.size() : 1;
        int all = figure;
        for (var body : level.bodies()) {
            DynamicShape shape = DynamicShape.of(body);
            Vec3 half = shape.half();
            all += count(half.x(), half.y() + shape.halfAxisMetres(), half.z());
        }
        // A body that reaches through a portal is in two places.
        all += all > figure && ViewTree.mayGrow(level) ? 1 : 0;
        return Math.min(MOST_SPHERES, all);
    }

    /** Returns the number of spheres along the longest side of a box. */
    private static int count(double halfX, double halfY, double halfZ) {
        double longest = Math.max(halfX, Math.max(halfY, halfZ));
        double others = (halfX + halfY + halfZ - longest) / 2;
        return (int) Math.max(1, Math.min(MOST_OF_BODY, Math.rint(longest / others)));
    }

    /**
     * Chooses and packs the objects whose reach a view of the frame may show; allocates nothing.
     *
     * @param main the frame's main view, {@code frustum} its bounds
     * @param views the tree of all views; {@code null} for the main view alone
     * @return the packed floats, eight a sphere, valid until the next call
     */
    public float[] choose(View main, Frustum frustum, ViewNode views) {
        chosen = 0;
        spheres = 0;
        for (int group = 0; group < dynamicObjects.groups().size(); group++) {
            int parts = dynamicObjects.groups().get(group).parts();
            for (int first = copies.start(group); first < copies.start(group + 1); first += parts) {
                if (parts > 1) {
                    packCharacter(first);
                } else if (value(first, 12) > 0) {
                    double reach = REACH_RADII * copies.ball(first, 3);
                    if (isSeen(first, reach, frustum, views)) {
                        insert(first, reach / Math.max(1e-3, distance(main, first)));
                    }
                }
            }
        }
        for (int i = 0; i < chosen; i++) {
            packBody(bodies[i]);
        }
        while (spheres < most) {
            put(NOWHERE, NOWHERE, NOWHERE, 1e-3, 0, 0);
        }
        return packed;
    }

    private boolean isSeen(int first, double reach, Frustum frustum, ViewNode views) {
        if (frustum.mayIntersect(copies.ball(first, 0), copies.ball(first, 1), copies.ball(first, 2), reach)) {
            return true;
        }
        for (int i = 0; views != null && i < views.children().size(); i++) {
            ViewNode child = views.children().get(i);
            if (!child.isTerminal() && isSeen(first, reach, child.frustum(), child)) {
                return true;
            }
        }
        return false;
    }

    private double distance(View view, int first) {
        double x = copies.ball(first, 0) - view.eyeX();
        double y = copies.ball(first, 1) - view.eyeY();
        double z = copies.ball(first, 2) - view.eyeZ();
        return Math.sqrt(x * x + y * y + z * z);
    }

    private void insert(int first, double size) {
        int at = chosen;
        if (chosen < most) {
            chosen++;
        } else if (sizes[--at] >= size) {
            return;
        }
        for (; at > 0 && sizes[at - 1] < size; at--) {
            sizes[at] = sizes[at - 1];
            bodies[at] = bodies[at - 1];
        }
        sizes[at] = size;
        bodies[at] = first;
    }

    private float value(int instance, int at) {
        return copies.packed()[DynamicInstances.FLOATS * instance + at];
    }

    private void setFrame(int instance) {
        turn.set(value(instance, 0), value(instance, 1), value(instance, 2), value(instance, 3));
        centre.set(copies.ball(instance, 0), copies.ball(instance, 1), copies.ball(instance, 2));
        centre.sub(anchor.x(), anchor.y(), anchor.z());
    }

    /** Packs the spheres whose centres are in front of the portals that the copy reaches through; another copy has the others. */
    private void packCharacter(int first) {
        for (int i = 0; i < Ball.ALL.size(); i++) {
            Ball ball = Ball.ALL.get(i);
            int part = first + ball.part.ordinal();
            setFrame(part);
            double x = centre.x;
            double y = centre.y;
            double z = centre.z;
            turn.transform(centre.set(0, ball.middleY, ball.middleZ));
            if (value(part, 12) > 0 && before(part, 16) >= 0 && before(part, 20) >= 0) {
                int end = first + CharacterPart.ALL.length;
                put(x + centre.x, y + centre.y, z + centre.z, ball.radius, first, end);
            }
        }
    }

    /** Returns the signed distance of a point, relative to an instance's centre, to one of the instance's planes. */
    private double before(int instance, int plane) {
        return value(instance, plane) * centre.x
                + value(instance, plane + 1) * centre.y
                + value(instance, plane + 2) * centre.z
                + value(instance, plane + 3);
    }

    /** Packs one sphere, or a few along the longest side. */
    private void packBody(int body) {
        boolean isBox = value(body, 11) == DynamicShape.BOX;
        double halfX = value(body, 12);
        double halfY = value(body, 13) + value(body, 15);
        double halfZ = value(body, 14);
        int count = count(halfX, halfY, halfZ);
        double longest = Math.max(halfX, Math.max(halfY, halfZ));
        double x = halfX == longest ? halfX / count : halfX;
        double y = halfX != longest && halfY == longest ? halfY / count : halfY;
        double z = halfX != longest && halfY != longest ? halfZ / count : halfZ;
        // A quarter of a convex surface is its mean area of view (Cauchy 1832).
        double radius = isBox ? BOX_RADIUS * Math.sqrt((x * y + y * z + z * x) * 2 / Math.PI) : halfX;
        for (int i = 0; i < count; i++) {
            setFrame(body);
            double along = 2 * i + 1 - count;
            double left = centre.x;
            double low = centre.y;
            double near = centre.z;
            turn.transform(centre.set(
                    halfX - x > 0 ? along * x : 0, halfY - y > 0 ? along * y : 0, halfZ - z > 0 ? along * z : 0));
            put(left + centre.x, low + centre.y, near + centre.z, radius, body, body + 1);
        }
    }

    /** Packs a sphere if there is room, relative to the anchor. */
    private void put(double x, double y, double z, double radius, int firstInstance, int endInstance) {
        if (spheres < most) {
            int at = 4 * spheres;
            packed[at] = (float) x;
            packed[at + 1] = (float) y;
            packed[at + 2] = (float) z;
            packed[at + 3] = (float) radius;
            int owner = 4 * (most + spheres++);
            packed[owner] = (float) (0.25 / radius);
            packed[owner + 1] = firstInstance;
            packed[owner + 2] = endInstance;
        }
    }
}

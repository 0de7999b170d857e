package nephele.engine.scene.dynamic;

import java.util.Arrays;
import java.util.Objects;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.FrameState.ObserverSphere;
import nephele.engine.scene.FrameState.Posture;
import nephele.engine.scene.probe.SkyProbes;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * All copies of all dynamic objects at one instant, packed for shaders. An instance is one part of one copy; the
 * instances of a group are contiguous. One object serves all frames and does work only after a change.
 *
 * <p>An instance has {@link #FLOATS} floats: orientation x y z w; centre relative to the anchor, rounded, and its
 * material; the rounding error of the centre, and the shape's kind; half sides and half axis; two planes that clip it,
 * each a unit normal and the signed distance of the centre; the visible fractions of the sky towards +x, +y, +z, and
 * towards −x, −y, −z. Where light was baked it has {@link #BOUNCED_FLOATS} more in a list of their own: the radiance of
 * the static geometry around, red, green, blue and 0, for each of these axes.
 */
public final class DynamicInstances {
    public static final int FLOATS = 32;

    /** Floats of the light that other surfaces send to an instance. */
    public static final int BOUNCED_FLOATS = 4 * SkyProbes.VALUES;

    private static final int BALL = 4;
    /** The radius of a ball about the head's centre that contains the head and the distance of the near plane. */
    private static final double HEAD_METRES = 0.23;

    /** The signed distance to a plane that clips nothing. */
    private static final float FAR_METRES = 1e9f;

    private static final Vec3 UNIT = new Vec3(1, 1, 1);

    private final DynamicObjects dynamicObjects;
    private final Vec3 anchor;
    private final SkyProbes sky;
    private final float[] skyOfBodies;
    private final float[] openness;
    /** What the copies follow from, as of the last update: the bodies' poses, seven numbers each, and the rest. */
    private final double[] poses;

    private Portals portals;
    private Posture character;
    private ObserverSphere observer;
    private double seconds;
    /** The bodies whose centres, or the light there, the last update changed. */
    private final boolean[] moved;
    /** Whether the sky visibility of a body, or of anything, lacks what the probes have deferred. */
    private final boolean[] awaitsSky;

    private boolean anyAwaitsSky;
    private long skyVersion;

    private final PortalCopies places = new PortalCopies();
    private final int[] groupStart;
    private final int[] bodyStart;
    private final int[] bodyEnd;
    private final CharacterPose pose = new CharacterPose();
    private final Vector3d anchorOfCharacter = new Vector3d();
    private final DynamicShape[] characterShapes =
            Arrays.stream(CharacterPart.ALL).map(CharacterPart::shape).toArray(DynamicShape[]::new);
    private final DynamicShape[] oneShape = new DynamicShape[1];
    private final Vector3d centre = new Vector3d();
    private final Quaterniond turn = new Quaterniond();
    private float[] packed = new float[64 * FLOATS];
    /** Empty without baked light. */
    private float[] bounced;

    private double[] balls = new double[64 * BALL];
    private int instances;
    private long version;

    /**
     * Makes the copies of a level's dynamic objects.
     *
     * @param anchor world position that packed centres are relative to, metres
     * @param sky {@code null} if sky visibility is not needed
     */
    public DynamicInstances(DynamicObjects dynamicObjects, Vec3 anchor, SkyProbes sky) {
        this.sky = sky;
        this.dynamicObjects = dynamicObjects;
        this.anchor = anchor;
        poses = new double[7 * dynamicObjects.shapes().size()];
        Arrays.fill(poses, Double.NaN);
        moved = new boolean[dynamicObjects.shapes().size()];
        groupStart = new int[dynamicObjects.groups().size() + 1];
        bodyStart = new int[dynamicObjects.shapes().size()];
        bodyEnd = new int[dynamicObjects.shapes().size()];
        openness = new float[sky == null ? SkyProbes.VALUES : sky.values()];
        skyOfBodies = new float[openness.length * dynamicObjects.shapes().size()];
        awaitsSky = new boolean[moved.length];
        bounced = new float[isLit() ? 64 * BOUNCED_FLOATS : 0];
        Arrays.fill(openness, 1);
    }

    /**
     * Updates the copies to {@code frameState}.
     *
     * @return a number that changes with every change
     */
    public long update(FrameState frameState) {
        if (keep(frameState) || version == 0 || anyAwaitsSky) {
            instances = 0;
            anyAwaitsSky = false;
            for (int group = 0; group < dynamicObjects.groups().size(); group++) {
                groupStart[group] = instances;
                for (int member : dynamicObjects.members().get(group)) {
                    if (member == DynamicObjects.FIGURE) {
                        addFigure(frameState);
                    } else {
                        add(frameState, member);
                    }
                }
            }
            groupStart[groupStart.length - 1] = instances;
            version++;
        }
        return version;
    }

    /** Keeps what the copies follow from. Returns true if any of it has changed. */
    private boolean keep(FrameState frameState) {
        boolean isRelit = sky != null && sky.version() != skyVersion;
        boolean changed = isRelit
                || frameState.character() != null && seconds != frameState.seconds()
                || !Objects.equals(frameState.character(), character)
                || !Objects.equals(frameState.observer(), observer)
                || frameState.portals() != portals;
        skyVersion = sky == null ? 0 : sky.version();
        observer = frameState.observer();
        character = frameState.character();
        seconds = frameState.seconds();
        portals = frameState.portals();
        for (int body = 0; body < moved.length; body++) {
            frameState.centre(body, centre);
            frameState.orientation(body, turn);
            moved[body] = keep(7 * body, centre.x, centre.y, centre.z) | isRelit;
            changed |= moved[body];
            changed |= keep(7 * body + 3, turn.x, turn.y, turn.z);
            changed |= keep(7 * body + 4, turn.y, turn.z, turn.w);
        }
        return changed;
    }

    /** Keeps three numbers and returns true if one has changed. */
    private boolean keep(int at, double x, double y, double z) {
        boolean isOther = poses[at] != x || poses[at + 1] != y || poses[at + 2] != z;
        poses[at] = x;
        poses[at + 1] = y;
        poses[at + 2] = z;
        return isOther;
    }

    private void add(FrameState frameState, int body) {
        frameState.centre(body, centre);
        frameState.orientation(body, turn);
        places.begin(1);
        places.place(0, centre, turn, centre);
        oneShape[0] = dynamicObjects.shapes().get(body);
        bodyStart[body] = instances;
        places.makeCopies(frameState.portals(), oneShape);
        for (int copy = 0; copy < places.copies(); copy++) {
            if (copy == 0) {
                lookUpSkyOf(body);
            } else {
                lookUpSky(copy);
            }
            pack(PortalCopies.slot(copy, 0), oneShape[0], dynamicObjects.materialOf()[body]);
        }
        bodyEnd[body] = instances;
    }

    private void addFigure(FrameState frameState) {
        if (frameState.observer() == null) {
            addCharacter(frameState);
        } else {
            addObserver(frameState);
        }
    }

    private void addObserver(FrameState frameState) {
        FrameState.ObserverSphere sphere = frameState.observer();
        centre.set(sphere.centre().x(), sphere.centre().y(), sphere.centre().z());
        places.begin(1);
        places.place(0, centre, turn.identity(), centre);
        oneShape[0] = DynamicShape.sphere(sphere.radiusMetres());
        places.makeCopies(frameState.portals(), oneShape);
        for (int copy = 0; copy < places.copies(); copy++) {
            lookUpSky(copy);
            pack(PortalCopies.slot(copy, 0), oneShape[0], dynamicObjects.observerMaterial(sphere.touches()));
        }
    }

    private void addCharacter(FrameState frameState) {
        if (frameState.character() == null) {
            return;
        }
        pose.compute(frameState.character(), frameState.seconds());
        Vec3 middle = frameState.character().centre();
        anchorOfCharacter.set(middle.x(), middle.y(), middle.z());
        places.begin(CharacterPart.ALL.length);
        for (CharacterPart part : CharacterPart.ALL) {
            places.place(part.ordinal(), pose.centre(part), pose.orientation(part), anchorOfCharacter);
        }
        places.makeCopies(frameState.portals(), characterShapes);
        for (int copy = 0; copy < places.copies(); copy++) {
            lookUpSky(copy);
            for (int part = 0; part < characterShapes.length; part++) {
                pack(PortalCopies.slot(copy, part), characterShapes[part], dynamicObjects.characterMaterial());
            }
        }
    }

    /** Sets the sky visibility of a body, which is looked up again only after the body has moved. */
    private void lookUpSkyOf(int body) {
        int at = openness.length * body;
        if (sky != null && (moved[body] || awaitsSky[body])) {
            awaitsSky[body] = !lookUpSky(0);
            System.arraycopy(openness, 0, skyOfBodies, at, openness.length);
        } else if (sky != null) {
            System.arraycopy(skyOfBodies, at, openness, 0, openness.length);
        }
    }

    /**
     * Looks up the sky visibility at a position in front of every portal: the copy's centre may be inside a wall.
     *
     * @return false if another lookup is to follow
     */
    private boolean lookUpSky(int copy) {
        if (sky == null) {
            return true;
        }
        places.openPlace(copy, centre);
        boolean isComplete = sky.at(centre.x, centre.y, centre.z, openness, 0);
        anyAwaitsSky |= !isComplete;
        return isComplete;
    }

    /** Returns true if the level's light was baked. */
    public boolean isLit() {
        return openness.length > SkyProbes.VALUES;
    }

    private void pack(int slot, DynamicShape shape, int material) {
        if ((instances + 1) * FLOATS > packed.length) {
            packed = Arrays.copyOf(packed, 2 * packed.length);
            balls = Arrays.copyOf(balls, 2 * balls.length);
            bounced = Arrays.copyOf(bounced, 2 * bounced.length);
        }
        places.centre(slot, centre);
        places.orientation(slot, turn);
        int ball = BALL * instances;
        balls[ball] = centre.x;
        balls[ball + 1] = centre.y;
        balls[ball + 2] = centre.z;
        balls[ball + 3] = shape.reachMetres();
        for (int value = SkyProbes.VALUES; value < openness.length; value++) {
            int from = value - SkyProbes.VALUES;
            bounced[BOUNCED_FLOATS * instances + 4 * (from / 3) + from % 3] = openness[value];
        }
        int at = FLOATS * instances++;
        put(at, (float) turn.x, (float) turn.y, (float) turn.z, (float) turn.w);
        double x = centre.x - anchor.x();
        double y = centre.y - anchor.y();
        double z = centre.z - anchor.z();
        put(at + 4, (float) x, (float) y, (float) z, material);
        put(at + 8, (float) (x - (float) x), (float) (y - (float) y), (float) (z - (float) z), shape.kind());
        Vec3 half = !places.isShown(slot) ? Vec3.ZERO : shape.kind() == DynamicShape.PART ? UNIT : shape.half();
        put(at + 12, (float) half.x(), (float) half.y(), (float) half.z(), (float) shape.halfAxisMetres());
        putPlane(at + 16, slot, 0);
        putPlane(at + 20, slot, 1);
        put(at + 24, openness[0], openness[1], openness[2], 0);
        put(at + 28, openness[3], openness[4], openness[5], 0);
    }

    private void putPlane(int at, int slot, int plane) {
        if (plane < places.planes(slot)) {
            put(
                    at,
                    (float) places.plane(slot, plane, 0),
                    (float) places.plane(slot, plane, 1),
                    (float) places.plane(slot, plane, 2),
                    (float) places.plane(slot, plane, 3));
        } else {
            put(at, 0, 0, 0, FAR_METRES);
        }
    }

    private void put(int at, float x, float y, float z, float w) {
        packed[at] = x;
        packed[at + 1] = y;
        packed[at + 2] = z;
        packed[at + 3] = w;
    }

    /** Returns the packed instances; valid up to {@link #instances}. */
    public float[] packed() {
        return packed;
    }

    /** Returns the light that other surfaces send to the instances, as {@link #packed}; empty without baked light. */
    public float[] bounced() {
        return bounced;
    }

    public int instances() {
        return instances;
    }

    /** Returns the first instance of a group; for the index after the last group, the number of instances. */
    public int start(int group) {
        return groupStart[group];
    }

    /** Returns the first instance of a body; its others follow. */
    int bodyStart(int body) {
        return bodyStart[body];
    }

    /** Returns the instance after a body's last one. */
    int bodyEnd(int body) {
        return bodyEnd[body];
    }

    /** Returns true if the head of the copy that begins with {@code instance} contains a point. */
    boolean headContains(int instance, int parts, Vector3d eye) {
        int head = BALL * (instance + parts - 1);
        double x = balls[head] - eye.x;
        double y = balls[head + 1] - eye.y;
        double z = balls[head + 2] - eye.z;
        return x * x + y * y + z * z < HEAD_METRES * HEAD_METRES;
    }

    /** Returns component 0–2 of the centre of an instance's bounding sphere, or 3 for its radius; world metres. */
    double ball(int instance, int component) {
        return balls[BALL * instance + component];
    }
}

package nephele.engine.scene;

import java.util.Arrays;
import java.util.List;
import nephele.engine.level.Body;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.math.Basis;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Passage;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * What is drawn besides what never changes: portals, bodies, the player's figure and the light outside at one instant. Whoever plays fills
 * it before a frame; one object serves frame after frame.
 */
public final class Moment {
    /** Doubles a body: centre, then orientation x y z w. */
    private static final int STRIDE = 7;

    /** In place of a body's number. */
    public static final int NOTHING = -1;

    private final double[] bodies;
    private Environment environment;
    private double seconds;
    private Portals portals;
    private double[] openness;
    private int[] colours;
    private Posture figure;
    private List<Ghost> ghosts = List.of();
    private int held = NOTHING;
    private Vec3 heldFromEye = Vec3.ZERO;
    private double heldClarity;

    private Moment(Environment environment, int bodyCount) {
        this.environment = environment;
        bodies = new double[STRIDE * bodyCount];
    }

    /** A level before its first tick: its own portals open, its bodies where they begin, nobody in it. */
    public static Moment atStart(Level level) {
        Moment start = new Moment(level.environment(), level.bodies().size());
        for (int i = 0; i < level.bodies().size(); i++) {
            Body body = level.bodies().get(i);
            start.body(i, body.centre().toVector(), new Quaterniond());
        }
        start.portals(Portals.of(level));
        return start;
    }

    /** The light outside as it is now. */
    public Environment environment() {
        return environment;
    }

    /**
     * Another light outside, as of another hour.
     *
     * @param now differs from the level's in the sun's direction and irradiance, the sky's radiance and the exposure only
     */
    public void environment(Environment now) {
        environment = now;
    }

    /** Simulated time: what moves of itself moves by it. */
    public double seconds() {
        return seconds;
    }

    public void seconds(double now) {
        seconds = now;
    }

    public Portals portals() {
        return portals;
    }

    /** Replaces the portals; new ones are fully open and of the colour {@code 2 + index}. */
    public void portals(Portals now) {
        if (now == portals) {
            return;
        }
        portals = now;
        openness = new double[now.size()];
        colours = new int[now.size()];
        Arrays.fill(openness, 1);
        Arrays.setAll(colours, portal -> 2 + portal);
    }

    /** How far a portal has opened since it was made, 0 to 1: its aperture is drawn scaled by it. */
    public double openness(int portal) {
        return openness[portal];
    }

    /** 0 and 1 for the two shots, 2 and more for those of the level. */
    public int colour(int portal) {
        return colours[portal];
    }

    public void look(int portal, int colour, double open) {
        colours[portal] = colour;
        openness[portal] = open;
    }

    public int bodies() {
        return bodies.length / STRIDE;
    }

    public void body(int index, Vector3dc centre, Quaterniondc worldFromBody) {
        int at = STRIDE * index;
        bodies[at] = centre.x();
        bodies[at + 1] = centre.y();
        bodies[at + 2] = centre.z();
        bodies[at + 3] = worldFromBody.x();
        bodies[at + 4] = worldFromBody.y();
        bodies[at + 5] = worldFromBody.z();
        bodies[at + 6] = worldFromBody.w();
    }

    public Vector3d centre(int body, Vector3d out) {
        int at = STRIDE * body;
        return out.set(bodies[at], bodies[at + 1], bodies[at + 2]);
    }

    /** World from body. */
    public Quaterniond orientation(int body, Quaterniond out) {
        int at = STRIDE * body + 3;
        return out.set(bodies[at], bodies[at + 1], bodies[at + 2], bodies[at + 3]);
    }

    /** How the player's figure stands, {@code null} where nobody is to be seen. */
    public Posture figure() {
        return figure;
    }

    public void figure(Posture now) {
        figure = now;
    }

    /** The body that is looked at with the eyes of whoever holds it, or {@link #NOTHING}: it is drawn see-through. */
    public int held() {
        return held;
    }

    /** Where {@link #held} is from the eye, metres to its right, up and back, along the portals that it is held through. */
    public Vec3 heldFromEye() {
        return heldFromEye;
    }

    /** How far it has become see-through: 0 solid, 1 as clear as it gets. */
    public double heldClarity() {
        return heldClarity;
    }

    public void held(int body, Vec3 fromEye, double clarity) {
        held = body;
        heldFromEye = fromEye;
        heldClarity = clarity;
    }

    /** Whatever is held is as solid as the rest. */
    public void nothingHeld() {
        held = NOTHING;
    }

    /** Where shots would open portals now. */
    public List<Ghost> ghosts() {
        return ghosts;
    }

    public void ghosts(List<Ghost> now) {
        ghosts = now;
    }

    /**
     * How a figure stands.
     *
     * @param centre of its body: on one side of every portal
     * @param up from feet to head, unit length
     * @param yawRadians where it looks, as {@code math.Basis.ofYawPitch} has it; {@code pitchRadians} alike
     * @param heightMetres from sole to crown now
     * @param step of the walking cycle that has passed, 0 to 1 for left and right; a second adds {@link
     *     nephele.engine.scene.thing.Gait#cyclesPerSecond}, so that no foot slides
     * @param stride speed over the ground by {@link nephele.engine.scene.thing.Gait#WALKING_METRES_PER_SECOND}: 0 standing
     * @param travelRadians where it walks, seen from where it looks: 0 ahead, positive to the left, π backwards
     * @param airborne 0 on the ground, 1 in the air
     * @param carrying 0 with free hands, 1 with a thing before it
     */
    public record Posture(
            Vec3 centre,
            Vec3 up,
            double yawRadians,
            double pitchRadians,
            double heightMetres,
            double step,
            double stride,
            double travelRadians,
            double airborne,
            double carrying) {
        /** As the same figure stands beyond a portal. */
        public Posture through(Passage passage) {
            Vec3 turned = passage.direction(up);
            Vector3d back = Basis.ofYawPitch(yawRadians, 0).back().toVector();
            passage.direction(leaning(up).transform(back));
            leaning(turned).transformInverse(back);
            return new Posture(
                    passage.point(centre),
                    turned,
                    Math.atan2(back.x, back.z),
                    pitchRadians,
                    heightMetres,
                    step,
                    stride,
                    travelRadians,
                    airborne,
                    carrying);
        }

        /** Turns what stands upright by the shortest way. */
        public static Quaterniond leaning(Vec3 up) {
            return Rotations.renormalised(new Quaterniond().rotationTo(0, 1, 0, up.x(), up.y(), up.z()));
        }
    }
}

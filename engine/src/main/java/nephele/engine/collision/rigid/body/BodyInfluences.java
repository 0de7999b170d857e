package nephele.engine.collision.rigid.body;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.collision.RoundedHull;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The other inputs of a body step: characters, which push and are pushed, and held bodies. The owner fills it before
 * each step and reads the impulses afterwards; reused to avoid allocation.
 */
public final class BodyInfluences {
    /** Returns empty influences; nothing may be added to them. */
    public static BodyInfluences none() {
        return new BodyInfluences();
    }

    /**
     * A capsule that moves by its own rules. Bodies collide with it as with a body of its mass; their impulses are
     * summed up.
     */
    public static final class Character {
        public final RoundedHull upright;
        public final RoundedHull scratch;
        public final double massKilograms;
        public final Vector3d centre = new Vector3d();
        public final Vector3d velocity = new Vector3d();
        final Vector3d impulse = new Vector3d();
        private final Vector3d centreAtStart = new Vector3d();
        private final Vector3d velocityAtStart = new Vector3d();
        private final double halfAxisMetres;

        /** Makes an upright capsule of this whole height, caps included. */
        public Character(double radiusMetres, double heightMetres, double massKilograms) {
            upright = RoundedHull.uprightCapsule(radiusMetres, heightMetres);
            scratch = upright.copy();
            this.massKilograms = massKilograms;
            halfAxisMetres = heightMetres / 2 - radiusMetres;
        }

        public double halfAxisMetres() {
            return halfAxisMetres;
        }

        public double radiusMetres() {
            return upright.radiusMetres();
        }

        private void begin() {
            impulse.zero();
            centreAtStart.set(centre);
            velocityAtStart.set(velocity);
        }

        private void advance(double seconds) {
            centre.fma(seconds, velocity);
            impulse.div(massKilograms, velocity).add(velocityAtStart);
        }

        private void end() {
            centre.set(centreAtStart);
            velocity.set(velocityAtStart);
        }

        /** Sets the impulse from the velocity to which bodies have brought the character. */
        public void give(double vX, double vY, double vZ) {
            impulse.set(vX, vY, vZ).sub(velocityAtStart).mul(massKilograms);
        }

        /** Sets the centre and the velocity (m/s) for the next step. */
        public void move(Vector3dc newCentre, Vector3dc newVelocity) {
            centre.set(newCentre);
            velocity.set(newVelocity);
        }

        /** Returns the impulse in N s that bodies exerted in the last step, in the character's space. */
        public Vector3dc impulse() {
            return impulse;
        }
    }

    private final List<Character> characters = new ArrayList<>();
    private final ItemList driven = new ItemList();
    private final ItemList passing = new ItemList();
    private double[] drives = new double[12];

    /** Adds a character with which bodies collide in the next step. */
    public void add(Character character) {
        characters.add(character);
    }

    public void clearCharacters() {
        characters.clear();
    }

    public void clearDriven() {
        driven.clear();
    }

    /**
     * Drives a held body: it starts the tick with this motion and has no weight; obstacles still stop it.
     *
     * @param velocity m/s
     * @param spin angular velocity, rad/s in world axes
     */
    public void drive(int body, Vec3 velocity, Vec3 spin) {
        int at = 6 * driven.size();
        if (drives.length < at + 6) {
            drives = Arrays.copyOf(drives, 2 * drives.length);
        }
        driven.accept(body);
        drives[at] = velocity.x();
        drives[at + 1] = velocity.y();
        drives[at + 2] = velocity.z();
        drives[at + 3] = spin.x();
        drives[at + 4] = spin.y();
        drives[at + 5] = spin.z();
    }

    /**
     * Excludes contact between characters and this body: a character holds it, or has released it and still overlaps
     * it.
     */
    public void ignoreCharacters(int body) {
        passing.accept(body);
    }

    public void clearPassing() {
        passing.clear();
    }

    /** Begins a tick. */
    public void begin() {
        for (int i = 0; i < characters.size(); i++) {
            characters.get(i).begin();
        }
    }

    /** Moves the characters between two parts of a tick. */
    public void advance(double seconds) {
        for (int i = 0; i < characters.size(); i++) {
            characters.get(i).advance(seconds);
        }
    }

    /** Ends a tick: restores the characters' places and velocities, and keeps the impulses. */
    public void end() {
        for (int i = 0; i < characters.size(); i++) {
            characters.get(i).end();
        }
    }

    public boolean meetsCharacters(int body) {
        for (int i = 0; i < passing.size(); i++) {
            if (passing.get(i) == body) {
                return false;
            }
        }
        return true;
    }

    public int characters() {
        return characters.size();
    }

    public List<Character> characterList() {
        return characters;
    }

    public int driven() {
        return driven.size();
    }

    public int driven(int index) {
        return driven.get(index);
    }

    public double drive(int index, int component) {
        return drives[6 * index + component];
    }
}

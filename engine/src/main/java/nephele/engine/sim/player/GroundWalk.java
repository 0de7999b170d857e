package nephele.engine.sim.player;

import static nephele.engine.sim.state.PlayerDimensions.MIN_GROUND_NORMAL_Y;
import static nephele.engine.sim.state.PlayerDimensions.STEP_METRES;

import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Sweep;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Moves a player on ground: along slopes, up and down steps and along walls, without leaving the ground in between. */
final class GroundWalk {
    /**
     * A contact normal with a smaller upward component is that of a wall, even where the wall's upper edge borders on
     * ground.
     */
    private static final double MIN_EDGE_NORMAL_Y = 0.02;

    /** The least fraction of a walk that counts as progress. */
    private static final double LEAST_PROGRESS = 0.5;

    private static final double TOUCHING_METRES = 2 * Sweep.SKIN_METRES;

    private static final Vector3dc LEVEL = new Vector3d(0, 1, 0);

    private final CharacterMover mover;
    private final ContactPlanes walls = new ContactPlanes();
    private final Vector3d ground = new Vector3d();
    private final Vector3d start = new Vector3d();
    private final Vector3d startGround = new Vector3d();
    private final Vector3d frame = new Vector3d();
    private final Vector3d frameGround = new Vector3d();
    private final Vector3d stepped = new Vector3d();
    private final Vector3d budget = new Vector3d();
    private final Vector3d path = new Vector3d();
    private final Vector3d up = new Vector3d();
    private final Vector3d wall = new Vector3d();

    GroundWalk(CharacterMover mover) {
        this.mover = mover;
    }

    /** Returns the horizontal normals of the walls that stopped the last walk. */
    ContactPlanes walls() {
        return walls;
    }

    /** Returns the normal of the ground after the last walk or landing. */
    Vector3dc ground() {
        return ground;
    }

    /**
     * Walks the displacement {@code horizontal} (metres) from {@code place} on ground with the given normal.
     *
     * @return true if there is still ground below; if not, {@code place} is where the ground ended
     */
    boolean walk(RoundedHull shape, Vector3d place, Vector3dc horizontal, Vector3dc onGround) {
        start.set(place);
        startGround.set(onGround);
        ground.set(onGround);
        boolean blocked = walkLevel(shape, place, horizontal);
        if (blocked && stepUp(shape, place, horizontal)) {
            return true;
        }
        return standDown(shape, place, STEP_METRES);
    }

    /**
     * Walks as {@link #walk}, and where that leads hardly on, as if on level ground. On the edge of a round frame the
     * ground is a slope, and the way down it leads into the edge.
     */
    boolean walkOverFrames(RoundedHull shape, Vector3d place, Vector3dc horizontal, Vector3dc onGround) {
        frame.set(place);
        frameGround.set(onGround);
        boolean grounded = walk(shape, place, horizontal, frameGround);
        double progress = progress(place, horizontal);
        if (progress >= LEAST_PROGRESS * horizontal.lengthSquared()) {
            return grounded;
        }
        boolean levelGrounded = walk(shape, place.set(frame), horizontal, LEVEL);
        return progress(place, horizontal) > progress
                ? levelGrounded
                : walk(shape, place.set(frame), horizontal, frameGround);
    }

    /**
     * Returns true if the player, after a fall, touches ground that is not too steep. On an edge the contact normal
     * decides.
     */
    boolean land(RoundedHull shape, Vector3d place) {
        return mover.lower(shape, place, TOUCHING_METRES) && isLanding();
    }

    private boolean isLanding() {
        if (mover.lastSweep().normal().y() < MIN_GROUND_NORMAL_Y) {
            return false;
        }
        takeGround();
        return true;
    }

    private boolean standDown(RoundedHull shape, Vector3d place, double metres) {
        double before = place.y;
        if (mover.lower(shape, place, metres) && isSupport()) {
            takeGround();
            return true;
        }
        place.y = before;
        return false;
    }

    private boolean isSupport() {
        Sweep hit = mover.lastSweep();
        return hit.normal().y() >= MIN_GROUND_NORMAL_Y
                || (hit.normal().y() >= MIN_EDGE_NORMAL_Y && hit.upmostNormal().y() >= MIN_GROUND_NORMAL_Y);
    }

    /**
     * Sets the ground normal: of a step's edge that of its tread, of a ridge between two steep slopes the contact
     * normal.
     */
    private void takeGround() {
        Sweep hit = mover.lastSweep();
        ground.set(hit.upmostNormal().y() >= hit.normal().y() ? hit.upmostNormal() : hit.normal());
    }

    /** Slides along the ground plane and along walls. Returns true if a wall was hit. */
    private boolean walkLevel(RoundedHull shape, Vector3d place, Vector3dc horizontal) {
        walls.clear();
        budget.set(horizontal);
        for (int i = 0; i < CharacterMover.MAX_SLIDES && budget.lengthSquared() > 0; i++) {
            alongGround(budget, path);
            if (!mover.advanceUntilHit(shape, place, path)) {
                break;
            }
            Sweep hit = mover.lastSweep();
            budget.mul(1 - hit.fraction());
            if (hit.normal().y() >= MIN_GROUND_NORMAL_Y) {
                ground.set(hit.normal());
            } else {
                addWall(hit.normal());
                walls.removeComponentsInto(budget);
            }
        }
        return walls.size() > 0;
    }

    /**
     * Adds a wall for a steep slope or slanted ceiling: both stop like upright walls. A flat ceiling above a rising
     * floor stops the walk straight ahead.
     */
    private void addWall(Vector3dc normal) {
        wall.set(normal.x(), 0, normal.z());
        if (wall.lengthSquared() < 1e-6) {
            wall.set(-budget.x, 0, -budget.z);
        }
        walls.add(wall.normalize());
    }

    /** Sets {@code bent} to the horizontal displacement inclined along the ground, of the same length. */
    private void alongGround(Vector3dc horizontal, Vector3d bent) {
        double rise = -(ground.x * horizontal.x() + ground.z * horizontal.z()) / ground.y;
        double square = horizontal.lengthSquared();
        double scale = Math.sqrt(square / (square + rise * rise));
        bent.set(horizontal.x() * scale, rise * scale, horizontal.z() * scale);
    }

    /**
     * Sweeps up, along and down from the start of the walk. The result is kept if it leads farther along and onto
     * ground within a step's height.
     */
    private boolean stepUp(RoundedHull shape, Vector3d place, Vector3dc horizontal) {
        double levelProgress = progress(place, horizontal);
        stepped.set(start);
        double highest = supportHeight(shape) + STEP_METRES;
        up.set(0, highest - footHeight(shape), 0);
        mover.advanceUntilHit(shape, stepped, up);
        double lifted = stepped.y - start.y;
        mover.slide(shape, stepped, horizontal);
        boolean farther = progress(stepped, horizontal) > levelProgress + 1e-9;
        if (!farther
                || !standDown(shape, stepped, lifted + TOUCHING_METRES)
                || mover.lastSweep().point().y() > highest + 1e-6) {
            ground.set(startGround);
            return false;
        }
        place.set(stepped);
        keepWallsOf(mover.planes());
        return true;
    }

    private double footHeight(RoundedHull shape) {
        return start.y - (shape.greatest(1) + Sweep.SKIN_METRES);
    }

    /** Returns the height of the support at the start; it is above the foot if the capsule rolls over an edge. */
    private double supportHeight(RoundedHull shape) {
        if (mover.lower(shape, stepped, TOUCHING_METRES) && isSupport()) {
            double height = mover.lastSweep().point().y();
            stepped.set(start);
            return Math.max(footHeight(shape), height);
        }
        return footHeight(shape);
    }

    private void keepWallsOf(ContactPlanes met) {
        walls.clear();
        for (int i = 0; i < met.size(); i++) {
            if (met.normal(i).y() < MIN_GROUND_NORMAL_Y) {
                wall.set(met.normal(i).x(), 0, met.normal(i).z());
                if (wall.lengthSquared() > 1e-6) {
                    walls.add(wall.normalize());
                }
            }
        }
    }

    private double progress(Vector3dc to, Vector3dc along) {
        return (to.x() - start.x) * along.x() + (to.z() - start.z) * along.z();
    }
}

package nephele.mutants;

import static nephele.mutants.Mutant.Area.COLLISION;
import static nephele.mutants.Mutants.ENGINE;

import java.util.List;

/** Faults in sweeps, separations, portal openings and the formulas of rigid bodies. */
final class CollisionMutants {
    static final List<Mutant> ALL = List.of(
            new Mutant(
                    COLLISION,
                    "a box meets a solid without regard to the faces along its y axis",
                    ENGINE + "collision/SeparatingAxes.java",
                    "boxFaces(4, 1);",
                    "",
                    "SeparationTest"),
            new Mutant(
                    COLLISION,
                    "what starts in a solid is pushed out without the skin",
                    ENGINE + "collision/Depenetration.java",
                    "double path = Sweep.SKIN_METRES - least;",
                    "double path = -least;",
                    "DepenetrationTest"),
            new Mutant(
                    COLLISION,
                    "a ray that starts a hair behind a face does not enter there",
                    ENGINE + "collision/RayCast.java",
                    ">= -ON_SURFACE_METRES",
                    ">= 0",
                    "RayCastTest"),
            new Mutant(
                    COLLISION,
                    "of solids touched at once the last is kept",
                    ENGINE + "collision/Sweep.java",
                    "if (collider >= 0 && t >= fraction) {",
                    "if (collider >= 0 && t > fraction) {",
                    "SweepTest"),
            new Mutant(
                    COLLISION,
                    "the caves of portals side by side meet at the second one's edge",
                    ENGINE + "collision/ApertureVolume.java",
                    "edge.distance() + nearest / 2",
                    "edge.distance() + nearest",
                    "ApertureVolumeTest"),
            new Mutant(
                    COLLISION,
                    "ground beside a portal on it gives way as a wall does behind a portal",
                    ENGINE + "collision/ApertureVolume.java",
                    "if (!isOnGround) {",
                    "if (true) {",
                    "GroundOpeningTest"),
            new Mutant(
                    COLLISION,
                    "the frame of a portal on uneven ground ends above the ground",
                    ENGINE + "collision/ApertureVolume.java",
                    "FRAME_METRES + Math.max(0, stepMetres)",
                    "FRAME_METRES",
                    "GroundOpeningTest"),
            new Mutant(
                    COLLISION,
                    "the momentum of a tumbling body turns the wrong way",
                    ENGINE + "collision/rigid/body/FreeRotation.java",
                    "momentum[j] = cos * mj + sin * momentum[k];\n        momentum[k] = cos * momentum[k] - sin * mj;",
                    "momentum[j] = cos * mj - sin * momentum[k];\n        momentum[k] = cos * momentum[k] + sin * mj;",
                    "RigidStepTest"),
            new Mutant(
                    COLLISION,
                    "a capsule's inertia lacks the shift of its half balls",
                    ENGINE + "collision/rigid/body/BodyTable.java",
                    " + 3 * h * r / 8)",
                    ")",
                    "BodyTableTest"),
            new Mutant(
                    COLLISION,
                    "the way through an aperture is taken at the wrong share",
                    ENGINE + "portal/Portals.java",
                    "before / (before - behind)",
                    "before / (before + behind)",
                    "PortalsTest"));

    private CollisionMutants() {}
}

package nephele.lab.prove;

import java.util.List;

/** The registry of proofs, in the order in which {@code prove} without a name runs them. */
public final class Proofs {
    public static final List<Proof> ALL = List.of(
            new ClosedRoomProof(),
            new TraversalsProof(),
            new CrossingsProof(),
            new FallsProof(),
            new SkinProof(),
            new JitMatrixProof(),
            new SaveKillProof(),
            new MutantsProof(),
            new PortalIdsProof(),
            new PortalLightProof(),
            new MirrorsProof(),
            new ShadowEdgesProof(),
            new SceneCullingProof(),
            new RayProof(),
            new HeightFieldProof(4097),
            new RotationProof(),
            new PlacementProof(),
            new RetriangulationProof(),
            new SeparationProof(),
            new BodiesProof(),
            new PilesProof(40),
            new EnergyProof(),
            new MassRatiosProof(10),
            new DoorwayWalkProof(320, 180),
            new EyeCrossingsProof(),
            new EditsProof(10, 8, EditedTown::baked),
            new SoakProof());

    private Proofs() {}
}

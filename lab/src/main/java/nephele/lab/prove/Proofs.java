package nephele.lab.prove;

import java.util.List;
import nephele.lab.prove.geometry.CollisionBoundsProof;
import nephele.lab.prove.bodies.BodiesProof;
import nephele.lab.prove.bodies.EnergyProof;
import nephele.lab.prove.bodies.FallsProof;
import nephele.lab.prove.bodies.MassRatiosProof;
import nephele.lab.prove.bodies.PilesProof;
import nephele.lab.prove.cloud.CloudFlightProof;
import nephele.lab.prove.cloud.CloudImpostorsProof;
import nephele.lab.prove.cloud.CloudLawsProof;
import nephele.lab.prove.cloud.CloudReferenceProof;
import nephele.lab.prove.cloud.CloudSlabsProof;
import nephele.lab.prove.cloud.CloudStackProof;
import nephele.lab.prove.cloud.CloudVolumeProof;
import nephele.lab.prove.edits.EditedTown;
import nephele.lab.prove.edits.EditsProof;
import nephele.lab.prove.geometry.HeightFieldProof;
import nephele.lab.prove.geometry.RayProof;
import nephele.lab.prove.geometry.RotationProof;
import nephele.lab.prove.geometry.SeparationProof;
import nephele.lab.prove.geometry.SkinProof;
import nephele.lab.prove.geometry.TerrainDetailProof;
import nephele.lab.prove.input.InputsProof;
import nephele.lab.prove.picture.MirrorsProof;
import nephele.lab.prove.picture.PortalIdsProof;
import nephele.lab.prove.picture.PortalLightProof;
import nephele.lab.prove.picture.SceneCullingProof;
import nephele.lab.prove.picture.ShadowEdgesProof;
import nephele.lab.prove.picture.StandingOutProof;
import nephele.lab.prove.placement.PlacementProof;
import nephele.lab.prove.placement.RetriangulationProof;
import nephele.lab.prove.portals.ClosedRoomProof;
import nephele.lab.prove.portals.CrossingsProof;
import nephele.lab.prove.portals.DoorwayWalkProof;
import nephele.lab.prove.portals.EyeCrossingsProof;
import nephele.lab.prove.portals.RoomExitsProof;
import nephele.lab.prove.portals.TraversalsProof;
import nephele.lab.prove.portals.WalkInProof;
import nephele.lab.prove.process.JitMatrixProof;
import nephele.lab.prove.process.MutantsProof;
import nephele.lab.prove.process.SaveKillProof;
import nephele.lab.prove.process.SoakProof;
import nephele.lab.prove.proof.Proof;
import nephele.lab.prove.sky.AirFieldsProof;
import nephele.lab.prove.sky.SkySweepProof;
import nephele.lab.prove.sky.SkyTableProof;
import nephele.lab.prove.terrain.TerrainProof;
import nephele.lab.prove.cloud.CloudAutoProof;
import nephele.lab.prove.cloud.CloudRadianceProof;

/** The registry of proofs, in the order in which {@code prove} without a name runs them. */
public final class Proofs {
    public static final List<Proof> ALL = List.of(
            new ClosedRoomProof(),
            new TraversalsProof(),
            new CrossingsProof(),
            new WalkInProof(),
            new RoomExitsProof(),
            new FallsProof(),
            new SkinProof(),
            new JitMatrixProof(),
            SaveKillProof.LEVELS,
            SaveKillProof.SETTINGS,
            new MutantsProof(),
            new InputsProof(),
            new PortalIdsProof(),
            new PortalLightProof(),
            new MirrorsProof(),
            new ShadowEdgesProof(),
            new StandingOutProof(),
            new SceneCullingProof(),
            new RayProof(),
            new HeightFieldProof(4097),
            new CollisionBoundsProof(),
            new TerrainProof(),
            new TerrainDetailProof(4097),
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
            new CloudSlabsProof(),
            new CloudLawsProof(),
            new CloudReferenceProof(),
            new CloudVolumeProof(),
            new CloudFlightProof(),
            new CloudStackProof(),
            new CloudImpostorsProof(),
            new CloudRadianceProof(),
            new CloudAutoProof(),
            new AirFieldsProof(),
            new SkyTableProof(),
            new SkySweepProof(),
            new SoakProof());

    private Proofs() {}
}

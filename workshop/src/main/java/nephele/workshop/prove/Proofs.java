package nephele.workshop.prove;

import java.util.List;
import nephele.workshop.prove.bodies.BodiesProof;
import nephele.workshop.prove.bodies.EnergyProof;
import nephele.workshop.prove.bodies.FallsProof;
import nephele.workshop.prove.bodies.MassRatiosProof;
import nephele.workshop.prove.bodies.PilesProof;
import nephele.workshop.prove.cloud.AirFieldsProof;
import nephele.workshop.prove.cloud.CloudAutoProof;
import nephele.workshop.prove.cloud.CloudFlightProof;
import nephele.workshop.prove.cloud.CloudImpostorsProof;
import nephele.workshop.prove.cloud.CloudLawsProof;
import nephele.workshop.prove.cloud.CloudRadianceProof;
import nephele.workshop.prove.cloud.CloudSlabsProof;
import nephele.workshop.prove.cloud.CloudStackProof;
import nephele.workshop.prove.cloud.CloudVolumeProof;
import nephele.workshop.prove.cloud.MitsubaProof;
import nephele.workshop.prove.cloud.SkySweepProof;
import nephele.workshop.prove.cloud.SkyTableProof;
import nephele.workshop.prove.editor.EditorCommandsProof;
import nephele.workshop.prove.editor.EditorEventsProof;
import nephele.workshop.prove.editor.EditorOpenSaveProof;
import nephele.workshop.prove.editor.EditorPicturesProof;
import nephele.workshop.prove.editor.EditorStallsProof;
import nephele.workshop.prove.editor.JournalKillProof;
import nephele.workshop.prove.edits.EditedTown;
import nephele.workshop.prove.edits.EditsProof;
import nephele.workshop.prove.geometry.CollisionBoundsProof;
import nephele.workshop.prove.geometry.HeightFieldProof;
import nephele.workshop.prove.geometry.RayProof;
import nephele.workshop.prove.geometry.RotationProof;
import nephele.workshop.prove.geometry.SeparationProof;
import nephele.workshop.prove.geometry.SkinProof;
import nephele.workshop.prove.geometry.TerrainDetailProof;
import nephele.workshop.prove.geometry.TerrainProof;
import nephele.workshop.prove.picture.BakedLightProof;
import nephele.workshop.prove.picture.LeaksProof;
import nephele.workshop.prove.picture.MirrorsProof;
import nephele.workshop.prove.picture.PortalIdsProof;
import nephele.workshop.prove.picture.PortalLightProof;
import nephele.workshop.prove.picture.SceneCullingProof;
import nephele.workshop.prove.picture.ShadowEdgesProof;
import nephele.workshop.prove.picture.StandingOutProof;
import nephele.workshop.prove.portals.ClosedRoomProof;
import nephele.workshop.prove.portals.CrossingsProof;
import nephele.workshop.prove.portals.DoorwayLightProof;
import nephele.workshop.prove.portals.DoorwayWalkProof;
import nephele.workshop.prove.portals.EyeCrossingsProof;
import nephele.workshop.prove.portals.PlacementProof;
import nephele.workshop.prove.portals.RetriangulationProof;
import nephele.workshop.prove.portals.RoomExitsProof;
import nephele.workshop.prove.portals.TraversalsProof;
import nephele.workshop.prove.portals.WalkInProof;
import nephele.workshop.prove.process.InputsProof;
import nephele.workshop.prove.process.JitMatrixProof;
import nephele.workshop.prove.process.MutantsProof;
import nephele.workshop.prove.process.SaveKillProof;
import nephele.workshop.prove.process.SoakProof;
import nephele.workshop.prove.proof.Proof;

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
            new LeaksProof(),
            new BakedLightProof(),
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
            new DoorwayLightProof(24, 24, 1024),
            new EditsProof("edits", "", 10, 8, EditedTown::baked),
            new EditsProof("edits-baked", " with baked light", 10, 8, EditedTown::bouncing),
            new CloudSlabsProof(),
            new CloudLawsProof(),
            MitsubaProof.clouds(),
            MitsubaProof.interiors(),
            new CloudVolumeProof(),
            new CloudFlightProof(),
            new CloudStackProof(),
            new CloudImpostorsProof(),
            new CloudRadianceProof(),
            new CloudAutoProof(),
            new AirFieldsProof(),
            new SkyTableProof(),
            new SkySweepProof(),
            new SoakProof(),
            new JournalKillProof(5),
            new EditorCommandsProof(),
            new EditorOpenSaveProof(),
            new EditorEventsProof(),
            new EditorStallsProof(),
            new EditorPicturesProof(1));

    private Proofs() {}
}

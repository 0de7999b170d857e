package nephele.engine.choice;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.choice.ErrorTable.Row;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Level;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.sim.reach.EyeReach;
import nephele.host.named.LevelName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TechniqueChoiceTest {
    private static final String FORM = "volume puffs";

    /** Cheaper techniques err more. */
    private static final ErrorTable TABLE = new ErrorTable(List.of(
            row(CloudTechnique.SKYBOX, 3, 1),
            row(CloudTechnique.SKYPLANE, 40, 2),
            row(CloudTechnique.BILLBOARD, 12, 5),
            row(CloudTechnique.PARTICLES, 8, 20),
            row(CloudTechnique.VOLUME, 3, 10)));

    private static Row row(CloudTechnique technique, double percent, double cost) {
        return new Row(FORM, technique, 1, 10, 30, percent, cost);
    }

    private static Cloud cloud(double maxPixels, double maxPercent) {
        return new Cloud(
                        "c",
                        new Cloud.Extent.Volume(Vec3.ZERO, new Vec3(10, 10, 10)),
                        CloudTechnique.AUTO,
                        new Cloud.Density.Puffs(List.of(), null),
                        0.1,
                        1,
                        0)
                .with(new Cloud.Tolerance(maxPixels, maxPercent));
    }

    private static CloudSituation situation(double distance, double travel) {
        return new CloudSituation(FORM, 1, 10, 30, distance, 5, travel, false, null);
    }

    @ParameterizedTest
    @CsvSource({
        // pixels, per cent, distance, travel, technique
        "1,  10, 10000, 10,  SKYBOX", // 0.6 pixels of parallax
        "1,  10, 1000,  10,  VOLUME", // 6 pixels: the next cheapest within 10 %
        "10, 10, 1000,  10,  SKYBOX",
        "1,  15, 100,   10,  BILLBOARD",
        "1,  10, 100,   10,  VOLUME",
        "1,  15, 0,     10,  VOLUME", // the eye can be inside
        "1,  1,  100,   10,  VOLUME", // none: the least error
        "0,  50, 100,   10,  BILLBOARD",
    })
    void theCheapestTechniqueWithinTheAllowedErrorIsChosen(
            double pixels, double percent, double distance, double travel, CloudTechnique expected) {
        var choice = TechniqueChoice.of(cloud(pixels, percent), situation(distance, travel), TABLE);
        assertEquals(expected, choice.chosen().technique(), choice.toString());
        assertEquals(percent > 1, choice.inside());
    }

    @Test
    void aMovingCloudIsNotBaked() {
        var moving = new CloudSituation(FORM, 1, 10, 30, 1e5, 5, 1, true, null);
        assertEquals(
                CloudTechnique.VOLUME,
                TechniqueChoice.of(cloud(1, 10), moving, TABLE).chosen().technique());
    }

    @Test
    void aCloudThatSwaysComesNearer() {
        Cloud still = cloud(1, 10);
        Cloud swaying = still.with(new Cloud.Motion(Vec3.ZERO, new Vec3(20, 0, 0), 60, 0));
        Aabb bounds = Aabb.around(Vec3.ZERO, new Vec3(10, 10, 10));
        EyeReach reach = new EyeReach(
                List.of(new EyeReach.Part(Aabb.around(new Vec3(30, 0, 0), new Vec3(2, 2, 2)), EyeReach.Means.WALKING)));
        assertEquals(24, CloudSituation.of(still, bounds, 1, reach, 45).distanceMetres(), 1e-9);
        assertEquals(4, CloudSituation.of(swaying, bounds, 1, reach, 45).distanceMetres(), 1e-9);
        assertTrue(CloudSituation.of(swaying, bounds, 1, reach, 45).moves());
    }

    @Test
    void theRunnerUpIsWhatIsChosenWithoutTheFirst() {
        var choice = TechniqueChoice.of(cloud(1, 10), situation(1e5, 1), TABLE);
        assertEquals(CloudTechnique.VOLUME, choice.runnerUp().technique());
    }

    @Test
    void aPortalThatIsMovedMakesACloudReachableAndChangesTheChoice() {
        var opened = new LevelName("levels/samples/clouds-room.json").open();
        var open = technique(opened.placed());
        Level level = opened.level();
        List<PortalSpec> moved = new ArrayList<>();
        for (PortalSpec portal : level.portals()) {
            // The end in the court goes to the wall outside, beside the other one.
            boolean isInCourt = portal.centre().x() > 8;
            PortalSpec other = level.portals().get(portal == level.portals().get(0) ? 1 : 0);
            moved.add(isInCourt ? at(portal, other) : portal);
        }
        var shut = technique(opened.placed().edited(level.withPortals(moved)));
        assertAll(
                () -> assertEquals(CloudTechnique.VOLUME, open.chosen().technique(), open.toString()),
                () -> assertEquals(
                        EyeReach.Means.PORTALS, open.situation().nearest().means()),
                () -> assertTrue(shut.situation().distanceMetres() > 0, shut.toString()),
                () -> assertEquals(CloudTechnique.BILLBOARD, shut.chosen().technique(), shut.toString()));
    }

    private static PortalSpec at(PortalSpec portal, PortalSpec beside) {
        Vec3 centre = beside.centre().plus(new Vec3(1.6, 0, 0));
        return new PortalSpec(
                portal.id(),
                portal.linkedTo(),
                centre,
                beside.normal(),
                beside.up(),
                beside.widthMetres(),
                beside.heightMetres(),
                beside.shape());
    }

    private static TechniqueChoice technique(PlacedLevel placed) {
        Level level = placed.level();
        List<Cloud> tolerant = level.environment().clouds().stream()
                .map(cloud -> cloud.with(new Cloud.Tolerance(1, 15)))
                .toList();
        var environment = level.environment().withClouds(tolerant);
        return ChosenTechniques.of(
                        environment,
                        CloudColumns.of(environment, placed.assets()),
                        withoutCameras(level, placed),
                        TABLE)
                .choices()
                .get(0);
    }

    /** Returns the reach of the player alone: a camera of the sample is in the court. */
    private static EyeReach withoutCameras(Level level, PlacedLevel placed) {
        return new EyeReach(EyeReach.of(level, placed.statics()).parts().stream()
                .filter(part -> part.means() != EyeReach.Means.CAMERAS)
                .toList());
    }

    @ParameterizedTest
    @CsvSource({"1, 10", "0.1, 10", "10, 30", "100, 30", "3.1622776, 25"})
    void betweenNodesErrorsAreNearerToTheGreatestAndBeyondThemKept(double depth, double expected) {
        var table = new ErrorTable(List.of(
                new Row(FORM, CloudTechnique.VOLUME, 1, 10, 30, 10, 1),
                new Row(FORM, CloudTechnique.VOLUME, 10, 10, 30, 30, 1)));
        var at = new CloudSituation(FORM, depth, 10, 80, 1, 5, 0, false, null);
        assertEquals(expected, table.errorPercent(CloudTechnique.VOLUME, at).orElseThrow(), 1e-5);
        assertTrue(table.errorPercent(CloudTechnique.SKYBOX, at).isEmpty());
    }

    /** The cheapest is 10: one that costs 10.9 and is less wrong is chosen, one that costs 11.1 is not. */
    @ParameterizedTest
    @CsvSource({"10.9, BILLBOARD", "11.1, PARTICLES"})
    void ofTechniquesThatCostTheSameTheLeastWrongOneIsChosen(double cost, CloudTechnique chosen) {
        var table =
                new ErrorTable(List.of(row(CloudTechnique.PARTICLES, 9, 10), row(CloudTechnique.BILLBOARD, 2, cost)));
        var choice = TechniqueChoice.of(cloud(1, 10), situation(100, 1), table);
        assertEquals(chosen, choice.chosen().technique(), choice.toString());
    }

    /** The node of depth 10 at 60 degrees is missing: there the nearest one counts, and beside it those that there are. */
    @ParameterizedTest
    @CsvSource({"10, 10, 30", "1, 60, 50", "10, 60, 50", "100, 80, 50"})
    void missingNodesAreFilledFromTheNearest(double depth, double degrees, double expected) {
        var table = new ErrorTable(List.of(
                new Row(FORM, CloudTechnique.VOLUME, 1, 60, 30, 50, 1),
                new Row(FORM, CloudTechnique.VOLUME, 1, 10, 30, 10, 1),
                new Row(FORM, CloudTechnique.VOLUME, 10, 10, 30, 30, 1)));
        var at = new CloudSituation(FORM, depth, degrees, 30, 1, 5, 0, false, null);
        assertEquals(expected, table.errorPercent(CloudTechnique.VOLUME, at).orElseThrow(), 1e-9);
    }

    @Test
    void aTableIsReadAsItWasWritten() {
        assertEquals(TABLE.rows(), ErrorTable.read(TABLE.lines(), "t.csv").rows());
        assertFalse(ErrorTable.shipped().rows().isEmpty());
        var refined = TABLE.refined(new ErrorTable(List.of(row(CloudTechnique.SKYBOX, 1, 7))));
        assertEquals(TABLE.rows().size(), refined.rows().size());
        assertEquals(7, refined.cost(CloudTechnique.SKYBOX, situation(1, 1)).orElseThrow());
    }

    @ParameterizedTest
    @ValueSource(strings = {"a,b", "x,volume,1,2,3,4", "x,cube,1,2,3,4,5", "x,volume,1,2,3,4,five"})
    void aLineThatIsNoRowIsNamed(String line) {
        var failure = assertThrows(
                IllegalArgumentException.class, () -> ErrorTable.read(List.of(ErrorTable.HEADER, line), "t.csv"));
        assertTrue(failure.getMessage().startsWith("t.csv: line 2:"), failure.getMessage());
    }
}

package nephele.workshop.art.bench;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import nephele.engine.level.Camera;
import nephele.engine.level.Level;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Solid;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.rule.LevelRules;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The committed benchmark levels equal those of their generator and match the compared engines' formulas, which are
 * repeated here.
 */
class BenchLevelsTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "clear.json",
                "skybox.json",
                "boxes-1000.json",
                "boxes-10000.json",
                "boxes-500-stack.json",
                "bodies-200.json",
                "boxes-1000-portals.json",
                "portals-64.json",
                "terrain.json"
            })
    void committedFileIsWhatTheGeneratorMakes(String file) throws IOException {
        assertEquals(LevelJson.write(BenchLevels.all().get(file)), Files.readString(Path.of("levels/bench", file)));
    }

    @ParameterizedTest
    @CsvSource({"boxes-1000.json, 1000, 32", "boxes-1000-portals.json, 1000, 32", "boxes-10000.json, 10000, 100"})
    void boxesStandOnACentredGridOfSpacingTwo(String file, int count, int side) {
        Level level = BenchLevels.all().get(file);
        assertEquals(count, level.solids().size());
        for (int i = 0; i < count; i++) {
            Solid.Box box = (Solid.Box) level.solids().get(i);
            double x = 2.0 * (i - side * (i / side)) - (side - 1);
            double z = 2.0 * (i / side) - (side - 1);
            assertEquals(new Vec3(x, 0.5, z), box.centre());
            assertEquals(new Vec3(1, 1, 1), box.size());
        }
    }

    @ParameterizedTest
    @CsvSource({
        "clear.json, 0, 0, 0, 0.2617993878, 0, 0, 0",
        "skybox.json, 0, 0, 0, 0, 1, 0, 0.35",
        "boxes-1000.json, 3.2, 4.28, 16, 0.2617993878, 0, -0.15, 0",
        "boxes-1000-portals.json, 3.2, 4.28, 16, 0.2617993878, 0, -0.15, 0",
        "boxes-10000.json, 10, 7, 50, 0.2617993878, 0, -0.15, 0"
    })
    void cameraFollowsThePeersPath(
            String file, double slide, double y, double z, double sway, int turns, double rise, double nod) {
        Camera camera = BenchLevels.all().get(file).cameras().get(0);
        assertEquals(60, camera.path().size());
        assertEquals(60, camera.verticalFovDegrees());
        for (int frame = 0; frame < 60; frame++) {
            double phase = frame * StrictMath.PI / 30;
            double yaw = turns * phase + sway * StrictMath.sin(phase);
            double up = rise + nod * StrictMath.sin(phase);
            double length = StrictMath.hypot(1, up);
            Vec3 eye = camera.path().get(frame).position();
            Vec3 target = camera.path().get(frame).target();
            assertArrayEquals(
                    new double[] {slide * StrictMath.sin(phase), y, z}, new double[] {eye.x(), eye.y(), eye.z()}, 1e-5);
            assertArrayEquals(
                    new double[] {StrictMath.sin(yaw) / length, up / length, -StrictMath.cos(yaw) / length},
                    new double[] {target.x() - eye.x(), target.y() - eye.y(), target.z() - eye.z()},
                    1e-5);
        }
    }

    /**
     * The portals equal the compared engines' quad of their first nested view: 8 x 4.5 m, 12 m ahead of the first
     * camera and 0.3 m above its eye.
     */
    @Test
    void portalsFaceEachOtherTwelveMetresAheadAndBehind() {
        Level level = BenchLevels.all().get("boxes-1000-portals.json");
        PortalSpec ahead = level.portals().get(0);
        PortalSpec behind = level.portals().get(1);
        assertArrayEquals(new double[] {0, 4.58, 4, 8, 4.5}, measures(ahead), 1e-5);
        assertArrayEquals(new double[] {0, 4.58, 28, 8, 4.5}, measures(behind), 1e-5);
        assertEquals(List.of(new Vec3(0, 0, 1), new Vec3(0, 0, -1)), List.of(ahead.normal(), behind.normal()));
    }

    private static double[] measures(PortalSpec portal) {
        Vec3 centre = portal.centre();
        return new double[] {centre.x(), centre.y(), centre.z(), portal.widthMetres(), portal.heightMetres()};
    }

    /**
     * The portals are as many as a level may have, each is in its wall, and every aperture is within the picture in
     * every frame.
     */
    @Test
    void sixtyFourPortalsAreInSight() {
        Level level = BenchLevels.all().get("portals-64.json");
        assertEquals(64, level.portals().size());
        assertEquals(List.of(), LevelRules.checkRecords(level));
        Portals portals = Portals.of(level);
        for (Camera.Waypoint place : level.cameras().get(0).path()) {
            Basis view = Basis.lookAt(place.position(), place.target(), new Vec3(0, 1, 0), Basis.WORLD);
            for (int i = 0; i < portals.size(); i++) {
                assertInPicture(portals.portal(i), place.position().toVector(), view);
            }
        }
    }

    private static void assertInPicture(Portal portal, Vector3d eye, Basis view) {
        assertTrue(portal.inFront(eye.x, eye.y, eye.z) > 0, portal.id() + " is seen from behind");
        double tall = StrictMath.tan(StrictMath.toRadians(30));
        for (int corner = 0; corner < portal.aperture().corners(); corner++) {
            Vector3d to = portal.world(
                            portal.aperture().cornerX(corner), portal.aperture().cornerY(corner), 0)
                    .toVector()
                    .sub(eye);
            double ahead = -to.dot(view.back().toVector());
            assertTrue(Math.abs(to.dot(view.up().toVector())) < tall * ahead, portal.id());
            assertTrue(Math.abs(to.dot(view.right().toVector())) < tall * 16 / 9 * ahead, portal.id());
        }
    }

    @Test
    void lightGivesThePeersTexturesTimesAmbientPlusLambert() {
        Level level = BenchLevels.all().get("boxes-1000.json");
        assertEquals(0.8, level.environment().sun().irradiance().x() / StrictMath.PI, 1e-15);
        assertEquals(new Vec3(0.3, 0.3, 0.3), level.environment().ambient());
    }
}

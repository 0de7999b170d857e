package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.AirLight;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.ClearSky;
import nephele.engine.atmosphere.LightScatteredOnce;
import nephele.engine.level.Material;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** The reference sees surfaces through the air of an atmosphere: that of the straight line of the path's length. */
class AirTest {
    private static final Vec3 SUN = Directions.unit(new Vec3(0.6, 0.1, -0.8));
    private static final double WHITE = 0.8;
    private static final double IRRADIANCE = 4;
    private static final Vec3 EYE = new Vec3(0, 1, 2);

    private static TestLevel stage() {
        return new TestLevel()
                .sky(Sky.Atmosphere.CLEAR)
                .sun(SUN, IRRADIANCE)
                .ambient(1)
                .material("white", TestLevel.grey(WHITE));
    }

    private static void assertAir(double eyeHeight, double metres, float[] seen) {
        AirLight air = new ClearSky(AirTables.of(Air.CLEAR)).along(eyeHeight, new Vec3(0, 0, -1), SUN, metres);
        Vec3 left = air.transmittance();
        Vec3 added = air.radiance().scaled(IRRADIANCE);
        assertEquals(WHITE * left.x() + added.x(), seen[0], 1e-6);
        assertEquals(WHITE * left.y() + added.y(), seen[1], 1e-6);
        assertEquals(WHITE * left.z() + added.z(), seen[2], 1e-6);
    }

    /** The faces that are seen turn away from the sun. */
    @Test
    void aWallFadesByItsDistance() {
        TestLevel wall = stage().box("white", new Vec3(0, 0, -6000), new Vec3(900, 900, 2000));
        assertAir(1, 5002, Traced.towards(wall, EYE, new Vec3(0, 1, 0), 1));
    }

    /** 2 m to the portal, 5 km behind it, where the level is 3 km higher. */
    @Test
    void throughAPortalTheAirIsThatOfTheMovedEye() {
        TestLevel pair = stage().box("white", new Vec3(0, 1, -5), new Vec3(13, 6, 10))
                .box("white", new Vec3(0, 3001, -6000), new Vec3(900, 900, 2000))
                .portal("a", "b", new Vec3(0, 1, 0), new Vec3(0, 0, 1), 1, 2)
                .portal("b", "a", new Vec3(0, 3001, 0), new Vec3(0, 0, -1), 1, 2);
        assertAir(3001, 5002, Traced.towards(pair, EYE, new Vec3(0, 1, 0), 1));
    }

    /** With light that bounces, 5 km before a portal have the air of their place, and 5 km behind it that 8 km higher. */
    @Test
    void theAirBeforeAPortalIsThatOfItsOwnPlace() {
        Vec3 glow = TestLevel.grey(0.8);
        TestLevel pair = new TestLevel()
                .sky(Sky.Atmosphere.CLEAR)
                .sun(SUN, IRRADIANCE)
                .material(new Material("glow", Vec3.ZERO, null, null, null, null, glow, 1))
                .box("glow", new Vec3(0, 1, -5), new Vec3(13, 6, 10))
                .box("glow", new Vec3(0, 8001, -6000), new Vec3(900, 900, 2000))
                .portal("a", "b", new Vec3(0, 1, 0), new Vec3(0, 0, 1), 1, 2)
                .portal("b", "a", new Vec3(0, 8001, 0), new Vec3(0, 0, -1), 1, 2);
        Pinhole eye = Traced.eye(new Vec3(0, 1, 4000), new Vec3(0, 1, 0), 1e-7);
        float[] seen = Traced.picture(pair, eye, new TraceSettings(1, 1, 1, 1, 1, LightTransport.FULL));
        ClearSky sky = new ClearSky(AirTables.of(Air.CLEAR));
        AirLight low = sky.along(1, new Vec3(0, 0, -1), SUN, 4000);
        AirLight high = sky.along(8001, new Vec3(0, 0, -1), SUN, 5000);
        Vec3 behind = glow.times(high.transmittance()).addScaled(IRRADIANCE, high.radiance());
        Vec3 wanted = behind.times(low.transmittance()).addScaled(IRRADIANCE, low.radiance());
        assertEquals(0, wanted.minus(new Vec3(seen[0], seen[1], seen[2])).length(), 1e-6, wanted + " " + high);
    }

    /** With light that bounces, the air under a roof lacks what it would scatter once of the sun's light. */
    @Test
    void wallsShadeTheAir() {
        Vec3 sun = Directions.unit(new Vec3(0.3, 0.9, -0.3));
        Vec3 glow = TestLevel.grey(0.01);
        TestLevel hall = new TestLevel()
                .sky(Sky.Atmosphere.CLEAR)
                .castingSun(sun, IRRADIANCE)
                .material(new Material("glow", Vec3.ZERO, null, null, null, null, glow, 1))
                .box("glow", new Vec3(0, 1, -1500), new Vec3(900, 900, 1000))
                .box("glow", new Vec3(0, 600, 0), new Vec3(9000, 200, 9000));
        Pinhole eye = Traced.eye(EYE, new Vec3(0, 1, 0), 1e-7);
        float[] seen = Traced.picture(hall, eye, new TraceSettings(1, 1, 1, 1, 1, LightTransport.FULL));
        AirTables tables = AirTables.of(Air.CLEAR);
        Vec3 along = new Vec3(0, 0, -1);
        AirLight all = new ClearSky(tables).along(1, along, sun, 1002);
        Vec3 once = new LightScatteredOnce(tables).upTo(1, along, sun, new double[] {1002})[0];
        Vec3 wanted =
                glow.times(all.transmittance()).plus(all.radiance().minus(once).scaled(IRRADIANCE));
        assertEquals(0, wanted.minus(new Vec3(seen[0], seen[1], seen[2])).length(), 1e-6, wanted + ", once " + once);
    }
}

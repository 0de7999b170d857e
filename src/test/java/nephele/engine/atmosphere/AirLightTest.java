package nephele.engine.atmosphere;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AirLightTest {
    private static final ClearSky SKY = new ClearSky(AirTables.of(Air.CLEAR));
    private static final double PLANET = Air.PLANET_RADIUS_METRES;

    private static Vec3 unit(double elevationDegrees, double azimuthDegrees) {
        double elevation = Math.toRadians(elevationDegrees);
        double azimuth = Math.toRadians(azimuthDegrees);
        return new Vec3(
                Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation), -Math.cos(azimuth) * Math.cos(elevation));
    }

    private static void assertClose(Vec3 expected, Vec3 actual, double relative) {
        assertEquals(expected.x(), actual.x(), relative * Math.abs(expected.x()), "red");
        assertEquals(expected.y(), actual.y(), relative * Math.abs(expected.y()), "green");
        assertEquals(expected.z(), actual.z(), relative * Math.abs(expected.z()), "blue");
    }

    @ParameterizedTest
    @CsvSource({"2, 0, 40", "2, 30, 5", "3000, -0.5, -3", "10000, 60, 90"})
    void aPartWithoutEndIsTheSkyWhereTheRayMissesTheGround(double height, double elevation, double sunElevation) {
        Vec3 sun = unit(sunElevation, 0);
        Vec3 ray = unit(elevation, 50);
        AirLight whole = SKY.along(height, ray, sun, Double.POSITIVE_INFINITY);
        assertClose(SKY.radiance(height, ray, sun), whole.radiance(), 1e-9);
    }

    /** The second part begins where the first one ends, in the frame of that place. */
    @ParameterizedTest
    @CsvSource({
        "2, 0, 70, 30, 8000",
        "2, 12, 160, 2, 60000",
        "1500, -1, 20, -4, 50000",
        "9000, -20, 90, 60, 900",
        "0, 0.1, 0, 0, 1"
    })
    void twoPartsInARowAreOne(double height, double elevation, double azimuth, double sunElevation, double metres) {
        Vec3 sun = unit(sunElevation, 0);
        Vec3 ray = unit(elevation, azimuth);
        Vec3 from = new Vec3(0, PLANET + height, 0);
        Vec3 middle = from.plus(ray.scaled(metres));
        Vec3 up = middle.scaled(1 / middle.length());
        double between = ray.dot(sun);
        AirLight first = SKY.along(height, ray, sun, metres);
        AirLight second = inFrame(middle.length() - PLANET, ray.dot(up), sun.dot(up), between, 2 * metres);
        AirLight both = SKY.along(height, ray, sun, 3 * metres);
        assertClose(both.transmittance(), first.transmittance().times(second.transmittance()), 1e-6);
        assertClose(both.radiance(), first.radiance().plus(first.transmittance().times(second.radiance())), 1e-4);
    }

    private static AirLight inFrame(double height, double rayUp, double sunUp, double between, double metres) {
        double rayLevel = Math.sqrt(1 - rayUp * rayUp);
        double sunLevel = Math.sqrt(1 - sunUp * sunUp);
        double azimuth = (between - rayUp * sunUp) / (rayLevel * sunLevel);
        Vec3 sun = new Vec3(0, sunUp, -sunLevel);
        Vec3 ray = new Vec3(rayLevel * Math.sqrt(Math.max(0, 1 - azimuth * azimuth)), rayUp, -rayLevel * azimuth);
        return SKY.along(height, ray, sun, metres);
    }

    @Test
    void aShortPartScattersAndExtinguishesInProportionToItsLength() {
        Vec3 sun = unit(35, 0);
        AirLight metre = SKY.along(100, unit(0, 80), sun, 1);
        AirLight ten = SKY.along(100, unit(0, 80), sun, 10);
        assertClose(metre.radiance().scaled(10), ten.radiance(), 1e-3);
        double[] extinction = new double[Air.CHANNELS];
        Air.CLEAR.putExtinctionPerMetre(100, Air.molecules(100), Air.aerosols(100), extinction);
        assertEquals(Math.exp(-10 * extinction[2]), ten.transmittance().z(), 1e-8);
    }

    @Test
    void noLengthIsNoAir() {
        assertEquals(AirLight.NONE, SKY.along(100, unit(-5, 80), unit(35, 0), 0));
    }

    @Test
    void belowTheGroundTheAirIsThatOfTheGround() {
        double[] extinction = new double[Air.CHANNELS];
        Air.CLEAR.putExtinctionPerMetre(0, 1, 1, extinction);
        for (double height : new double[] {0, -500}) {
            AirLight down = SKY.along(height, unit(-90, 0), unit(35, 0), 1000);
            assertEquals(Math.exp(-1000 * extinction[1]), down.transmittance().y(), 1e-8);
            assertTrue(down.radiance().z() > 0, "the air of the ground is lit");
        }
    }

    @Test
    void aPartBehindThePlanetEndsAtTheTopOfTheAir() {
        AirLight far = SKY.along(0, unit(90, 0), unit(35, 0), 1e9);
        assertClose(SKY.along(0, unit(90, 0), unit(35, 0), Air.TOP_METRES).transmittance(), far.transmittance(), 1e-9);
    }
}

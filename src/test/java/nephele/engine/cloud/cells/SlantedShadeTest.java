package nephele.engine.cloud.cells;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ShortBuffer;
import java.util.List;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.MajorantWalk;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The shade of clouds along a slanting light. */
class SlantedShadeTest {
    private static final double BASE = 1000;
    private static final double TOP = 1400;
    private static final double PER_METRE = 0.002;
    private static final Vec3 LIGHT = new Vec3(0.48, 0.6, -0.64);
    private static final LayerGrid GRID = SlantedShade.grid(BASE, TOP, 50, 5, 2);

    /** A half space x < 0 of even extinction between base and top. */
    private record Half(double edge) implements ExtinctionField {
        @Override
        public double perMetre(double x, double y, double z) {
            return x < edge && y >= BASE && y <= TOP ? PER_METRE : 0;
        }

        @Override
        public Aabb bounds() {
            return new Aabb(-1e6, BASE, -1e6, edge, TOP, 1e6);
        }

        @Override
        public MajorantWalk walk(Ray ray, double fromMetres, double toMetres) {
            throw new UnsupportedOperationException("only its density is used");
        }
    }

    private static SlantedShade shade(Half field, Vec3 shift, double share) {
        return SlantedShade.of(GRID, GRID.around(0, 0), List.of(new SlantedShade.Caster(field, shift, share)), LIGHT);
    }

    private static double taken(SlantedShade shade, int level, int i, int j) {
        CellBox cells = shade.boxes().get(level);
        ShortBuffer texels = ShortBuffer.allocate(2 * cells.nx() * cells.ny());
        shade.put(shade, level, cells.nz() / 2, texels);
        return (texels.get(2 * (j * cells.nx() + i)) & 0xffff) / 65535.0;
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void anEvenLayerTakesByTheDepthThatIsAbove(int level) {
        SlantedShade shade = shade(new Half(1e6), Vec3.ZERO, 1);
        for (int j = 0; j < 5; j++) {
            double above = (TOP - BASE) * (4 - j) / 4.0;
            double wanted = -Math.expm1(-PER_METRE * above / LIGHT.y());
            assertEquals(wanted, taken(shade, level, 64, j), 2e-5);
        }
    }

    /** Rows are sheared along the light: a place's column is where its ray crosses the base. */
    @Test
    void theEdgeOfAShadowIsWhereTheLightCrossesTheBase() {
        SlantedShade shade = shade(new Half(0), Vec3.ZERO, 1);
        CellBox cells = shade.boxes().get(0);
        double slant = LIGHT.x() / LIGHT.y();
        for (int i = 0; i < cells.nx(); i++) {
            double heightInside = Math.max(0, Math.min(TOP - BASE, -cells.centreX(i) / slant));
            double wanted = -Math.expm1(-PER_METRE * heightInside / LIGHT.y());
            assertEquals(wanted, taken(shade, 0, i, 0), 0.02);
        }
    }

    @Test
    void aShiftMovesAndAShareThins() {
        SlantedShade moved = shade(new Half(0), new Vec3(-200, 0, 0), 1);
        SlantedShade other = shade(new Half(200), Vec3.ZERO, 1);
        SlantedShade half = shade(new Half(200), Vec3.ZERO, 0.5);
        for (int i = 0; i < 128; i++) {
            double whole = taken(other, 0, i, 0);
            assertEquals(whole, taken(moved, 0, i, 0), 1e-4);
            assertEquals(1 - Math.sqrt(1 - whole), taken(half, 0, i, 0), 1e-4);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 0.5, 0.02, 0, -0.3, -1})
    void theSlantIsFiniteForEveryLight(double sine) {
        double level = Math.sqrt(1 - sine * sine);
        Vec3 slant = SlantedShade.slant(new Vec3(level, sine, 0));
        assertTrue(slant.x() >= 0 && slant.x() <= 50 && slant.y() == 0 && slant.z() == 0, slant.toString());
        assertEquals(sine > 0.02 ? level / sine : slant.x(), slant.x(), 1e-9);
    }
}

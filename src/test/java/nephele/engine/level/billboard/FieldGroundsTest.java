package nephele.engine.level.billboard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.level.Billboards;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import org.junit.jupiter.api.Test;

class FieldGroundsTest {
    /** A roof of 30 degrees: its ridge runs along z at x = 8. */
    private static final HeightField ROOF = HeightField.of(
            new Vec3(-2, 3, 4), 1, 21, 11, (column, row) -> (10 - Math.abs(column - 10)) * Math.tan(Math.PI / 6));

    @Test
    void billboardsOfATerrainStandOnItsTriangles() {
        var field = new Billboards.Field("roof", 1, 40, 0.8, null, 90, null);
        List<Vec3> feet = BillboardField.plant(field, new FieldGrounds.TerrainGround(ROOF), null);
        assertEquals(40, feet.size());
        for (Vec3 foot : feet) {
            assertEquals(HeightFieldSurface.y(ROOF, foot.x(), foot.z()), foot.y(), 1e-9);
        }
    }

    @Test
    void besideTheTerrainAndOnItsSlopesIsNoGround() {
        var ground = new FieldGrounds.TerrainGround(ROOF);
        assertNull(ground.at(-2.1, 5));
        assertEquals(Math.cos(Math.PI / 6), ground.at(3.3, 9.2).normal().y(), 1e-6);
        var flat = new Billboards.Field("roof", 1, 40, 0.8, null, 20, null);
        List<Vec3> feet = BillboardField.plant(flat, ground, null);
        assertTrue(feet.stream().allMatch(foot -> Math.abs(foot.x() - 8) <= 1), feet.toString());
    }
}

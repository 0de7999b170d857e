package nephele.workshop.prove.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.ground.GroundSeat;
import nephele.workshop.prove.proof.Proof;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A portal on bumps of ±9 mm across a slope of 30 degrees: no ground is drawn before it. */
class GroundPortalIdsGlTest {
    private static final int SIDE = 61;
    private static final String LEVEL =
            "{'format': 'nephele-level', 'version': 1, 'name': 'ground', 'solids': [{'id': 'wall', 'kind': 'box',"
                    + " 'centre': [0, 4, -11], 'size': [20, 20, 1]}], 'terrains': [{'id': 'g', 'heightMap': 'map.r16',"
                    + " 'centre': [0, 0, 0], 'sizeMetres': [12, 12], 'heightRangeMetres': [-8, 8]}], 'portals': ["
                    + "{'id': 'p', 'linkedTo': 'q', 'centre': %s, 'normal': %s, 'up': %s, 'widthMetres': 1.2,"
                    + " 'heightMetres': 2.1, 'shape': 'arch'}, {'id': 'q', 'linkedTo': 'p', 'centre': [0, 3, -10.5],"
                    + " 'normal': [0, 0, 1], 'up': [0, 1, 0], 'widthMetres': 1.2, 'heightMetres': 2.1, 'shape':"
                    + " 'arch'}]}";

    @Test
    void noGroundCoversThePortal(@TempDir Path folder) throws IOException {
        ByteBuffer map = ByteBuffer.allocate(2 * SIDE * SIDE).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < SIDE * SIDE; i++) {
            double x = 0.2 * (i % SIDE) - 6;
            double height = x * Math.tan(Math.toRadians(30)) + 0.009 * Math.sin(7 * x) * Math.cos(i / SIDE - 30);
            map.putShort((short) (int) Math.round(65535 * (0.5 + height / 16)));
        }
        HeightField field = HeightField.of(
                new Vec3(-6, 0, -6),
                0.2,
                SIDE,
                SIDE,
                (column, row) -> -8 + 16 * (map.getShort(2 * (row * SIDE + column)) & 0xffff) / 65535.0);
        Vec3 on = new Vec3(0, HeightFieldSurface.y(field, 0, 0), 0);
        Aperture aperture = Aperture.of(PortalShape.ARCH, 1.2, 2.1);
        Vec3 north = new Vec3(0, 0, -1);
        Portal portal = GroundSeat.over(field, on, "p", aperture, normal -> {
                    return Directions.unit(north.addScaled(-north.dot(normal), normal));
                })
                .portal();
        Files.write(folder.resolve("map.r16"), map.array());
        Path file = Files.writeString(
                folder.resolve("ground.json"),
                LEVEL.formatted(
                                list(portal.centre()),
                                list(portal.normal()),
                                list(portal.frame().up()))
                        .replace('\'', '"'));
        var result = new PortalIdsProof(List.of(file.toString())).run(0, 5, Proof.Progress.NONE);
        assertEquals(0, result.failures(), () -> String.join("\n", result.examples()));
    }

    private static String list(Vec3 v) {
        return "[" + v.x() + ", " + v.y() + ", " + v.z() + "]";
    }
}

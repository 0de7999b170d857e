package nephele.lab.prove.cloud;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.zip.GZIPInputStream;
import nephele.engine.cloud.HenyeyGreenstein;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.cloud.field.GridField;
import nephele.engine.cloud.field.VolFile;
import nephele.engine.math.Aabb;
import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.measure.LinearPicture;
import nephele.engine.reference.volume.OutsideLight;

/**
 * A cloud with its picture by Mitsuba 3 (integrator volpath, 4096 samples a pixel, no limit on path length).
 *
 * @param halfWidth half the picture's width at depth 1
 * @param radiance rows from the bottom, as {@code error}
 * @param error standard error of each value of {@code radiance}
 */
record ReferenceCase(
        String name,
        CloudMedium medium,
        OutsideLight light,
        Vec3 eye,
        Basis basis,
        double halfWidth,
        LinearPicture radiance,
        LinearPicture error) {

    /** Reads a case from the resources of this package: "sphere", "puff" or "cumulus". */
    static ReferenceCase named(String name) {
        JsonObject scene = JsonParser.parseString(new String(bytes(name + ".json"), StandardCharsets.UTF_8))
                .getAsJsonObject();
        JsonObject camera = scene.getAsJsonObject("camera");
        JsonObject sun = scene.getAsJsonObject("sun");
        Vec3 eye = vector(camera, "position");
        var field = GridField.inBox(
                VolFile.parse(name + ".vol", bytes(name + ".vol.gz")),
                Aabb.around(vector(scene, "boxCentre"), vector(scene, "boxSize")),
                scene.get("extinctionMax_per_m").getAsDouble());
        return new ReferenceCase(
                name,
                new CloudMedium(
                        field,
                        scene.get("albedo").getAsDouble(),
                        new HenyeyGreenstein(scene.get("phaseG").getAsDouble())),
                new OutsideLight(
                        vector(sun, "directionTowardsSun"), vector(sun, "irradiance"), vector(scene, "skyRadiance")),
                eye,
                Basis.lookAt(eye, vector(camera, "target"), vector(camera, "up"), Basis.WORLD),
                Math.tan(Math.toRadians(camera.get("horizontalFovDegrees").getAsDouble()) / 2),
                picture(name + ".pfm.gz"),
                picture(name + "-se.pfm.gz"));
    }

    /**
     * Returns the ray of unit direction through a point of the picture.
     *
     * @param column pixels from the left border
     * @param row pixels from the lower border
     */
    Ray ray(double column, double row) {
        double right = (2 * column / radiance.width() - 1) * halfWidth;
        double up = (2 * row - radiance.height()) / radiance.width() * halfWidth;
        Vec3 ahead = basis.back().negated();
        return Ray.of(eye, Directions.unit(ahead.addScaled(right, basis.right()).addScaled(up, basis.up())));
    }

    private static Vec3 vector(JsonObject object, String member) {
        JsonArray v = object.getAsJsonArray(member);
        return new Vec3(v.get(0).getAsDouble(), v.get(1).getAsDouble(), v.get(2).getAsDouble());
    }

    private static byte[] bytes(String resource) {
        try (var in = ReferenceCase.class.getResourceAsStream(resource)) {
            return resource.endsWith(".gz") ? new GZIPInputStream(in).readAllBytes() : in.readAllBytes();
        } catch (IOException problem) {
            throw new UncheckedIOException(resource, problem);
        }
    }

    /** Reads a PFM: three lines of text, then little-endian floats. */
    private static LinearPicture picture(String resource) {
        byte[] file = bytes(resource);
        int start = 0;
        for (int lines = 0; lines < 3; start++) {
            lines += file[start] == '\n' ? 1 : 0;
        }
        String[] words = new String(file, 0, start, StandardCharsets.US_ASCII).split("\\s+");
        float[] rgb = new float[(file.length - start) / 4];
        ByteBuffer.wrap(file, start, file.length - start)
                .order(ByteOrder.LITTLE_ENDIAN)
                .asFloatBuffer()
                .get(rgb);
        return new LinearPicture(Integer.parseInt(words[1]), Integer.parseInt(words[2]), rgb);
    }
}

package nephele.workshop.prove.cloud;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.zip.GZIPInputStream;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.measure.LinearPicture;
import nephele.engine.reference.LightTransport;
import nephele.engine.reference.Pinhole;
import nephele.engine.reference.TracedLevel;
import nephele.engine.scene.View;
import nephele.host.named.Viewpoints;
import nephele.lab.bake.TracedPictures;

/**
 * A level of one cloud, or of a room, with its exact picture. Of the clouds three by Mitsuba 3 (integrator volpath, 4096 samples a pixel, no limit on path
 * length), three by {@code render --reference --error}. It is read and traced as that command does it.
 *
 * @param sky its radiance, which is all that a pixel without cloud has
 * @param radiance rows from the bottom, as {@code error}
 * @param error standard error of each value of {@code radiance}
 */
public record ReferenceCase(
        String name,
        PlacedLevel placed,
        TracedLevel level,
        View view,
        Vec3 sky,
        LinearPicture radiance,
        LinearPicture error) {
    /** Cases whose picture Mitsuba traced, from scenes in its own format. */
    static final List<String> OF_MITSUBA = List.of("sphere", "puff", "cumulus");

    /** Rooms without a cloud whose picture Mitsuba traced (integrator path, 4096 samples a pixel), written as levels. */
    public static final List<String> INTERIORS = List.of("cornell", "sunroom", "two-rooms", "furnace");

    /** Cases whose picture our own tracer made. */
    static final List<String> OWN = List.of("low-sun", "inside", "deck");

    /** Reads a case from the resources of this package. */
    public static ReferenceCase named(String name) {
        byte[] json = bytes(name + ".json");
        Level level = LevelJson.read(name, OF_MITSUBA.contains(name) ? converted(name, json) : json);
        LinearPicture radiance = picture(name + ".pfm.gz");
        double aspect = (double) radiance.width() / radiance.height();
        PlacedLevel placed = PlacedLevel.of(level, new Grids());
        return new ReferenceCase(
                name,
                placed,
                TracedLevel.of(placed, ColourDecoding.SRGB),
                Viewpoints.standard(level, name, aspect).apply(0),
                ((Sky.Constant) level.environment().sky()).radiance(),
                radiance,
                picture(name + "-se.pfm.gz"));
    }

    /** Returns how far light is followed in its picture: in our own, surfaces around clouds reflect none. */
    LightTransport transport() {
        return OWN.contains(name) ? LightTransport.DIRECT : LightTransport.FULL;
    }

    Pinhole eye() {
        return TracedPictures.pinhole(view);
    }

    private static byte[] converted(String name, byte[] scene) {
        JsonObject json = JsonParser.parseString(new String(scene, StandardCharsets.UTF_8))
                .getAsJsonObject();
        return level(name, json).toString().getBytes(StandardCharsets.UTF_8);
    }

    private static JsonObject level(String name, JsonObject scene) {
        var cloud = new JsonObject();
        cloud.addProperty("id", name);
        cloud.addProperty("kind", "volume");
        cloud.add("centre", scene.get("boxCentre"));
        cloud.add("size", scene.get("boxSize"));
        var density = new JsonObject();
        density.addProperty("kind", "grid");
        density.addProperty("file", name + ".vol");
        cloud.add("density", density);
        cloud.add("extinctionPerMetre", scene.get("extinctionMax_per_m"));
        cloud.add("albedo", scene.get("albedo"));
        cloud.add("phaseG", scene.get("phaseG"));
        var sky = new JsonObject();
        sky.addProperty("kind", "constant");
        sky.add("radiance", scene.get("skyRadiance"));
        var environment = new JsonObject();
        environment.add("sun", scene.get("sun"));
        environment.add("sky", sky);
        environment.add("clouds", list(cloud));
        JsonObject camera = scene.getAsJsonObject("camera");
        camera.remove("width");
        camera.remove("height");
        camera.addProperty("id", "main");
        var level = new JsonObject();
        level.addProperty("format", "nephele-level");
        level.addProperty("version", 1);
        level.add("environment", environment);
        level.add("cameras", list(camera));
        return level;
    }

    private static JsonArray list(JsonObject only) {
        var list = new JsonArray();
        list.add(only);
        return list;
    }

    /** The grids of the cases. */
    private record Grids() implements AssetSource {
        @Override
        public byte[] bytes(String assetId) {
            return ReferenceCase.bytes(assetId + ".gz");
        }

        @Override
        public boolean exists(String assetId) {
            return ReferenceCase.class.getResource(assetId + ".gz") != null;
        }
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

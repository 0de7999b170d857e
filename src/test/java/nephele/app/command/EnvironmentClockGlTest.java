package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code render --time} sets the clock of a sky whose sun moves, drawn and traced. */
class EnvironmentClockGlTest {
    private static final int HEADER_BYTES = "PF\n24 16\n-1.0\n".length();
    private static final float SAME = 1e-4f;
    private static final int FOUR_YEARS_SECONDS = 1461 * 600;

    @TempDir
    Path folder;

    private String level(double hours) throws IOException {
        return Files.writeString(
                        folder.resolve("hour-" + hours + ".json"),
                        "{\"format\": \"nephele-level\", \"version\": 1, \"environment\": {\"sky\": {\"kind\":"
                                + " \"atmosphere\", \"timeOfDayHours\": "
                                + hours
                                + ", \"dayLengthSeconds\": 600}}, \"solids\": [{\"id\": \"floor\", \"kind\": \"box\","
                                + " \"centre\": [0, 0, -9], \"size\": [9, 1, 9]}], \"player\": {\"feet\": [0, 1, 0]}}")
                .toString();
    }

    private float[] picture(String level, String... more) throws IOException {
        Path file = folder.resolve("picture.pfm");
        List<String> words = new ArrayList<>(List.of("render", level, "--out", file.toString(), "--size", "24x16"));
        words.addAll(Arrays.asList(more));
        var answer = Captured.run(words.toArray(String[]::new));
        assertEquals(0, answer.exitCode(), answer.err());
        assertFalse(answer.err().contains("nothing"), answer.err());
        FloatBuffer numbers = ByteBuffer.wrap(Files.readAllBytes(file), HEADER_BYTES, 24 * 16 * 12)
                .order(ByteOrder.LITTLE_ENDIAN)
                .asFloatBuffer();
        float[] radiance = new float[numbers.remaining()];
        numbers.get(radiance);
        return radiance;
    }

    @Test
    void aDrawnPictureHasTheSunOfItsTime() throws IOException {
        float[] morning = picture(level(8));
        float[] noon = picture(level(8), "--time", "100");
        assertFalse(Arrays.equals(morning, noon));
        assertArrayEquals(picture(level(12)), noon, SAME, "a sixth of a day later");
        float[] months = picture(level(8), "--time", "" + (100 + 3 * FOUR_YEARS_SECONDS));
        assertArrayEquals(noon, months, SAME, "after thirty days");
    }

    @Test
    void aTracedPictureHasTheSunOfItsTime() throws IOException {
        float[] noon = picture(level(8), "--time", "100", "--reference", "--spp", "1");
        assertArrayEquals(picture(level(12), "--reference", "--spp", "1"), noon, SAME);
        assertTrue(!Arrays.equals(picture(level(8), "--reference", "--spp", "1"), noon));
    }
}

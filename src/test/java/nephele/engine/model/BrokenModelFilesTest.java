package nephele.engine.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.model.file.MeshText;
import nephele.engine.model.file.ModelFiles;
import nephele.engine.model.shape.BezierPatches;
import nephele.engine.model.shape.BezierShape;
import nephele.engine.model.shape.BoxShape;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every file gives a mesh or a message with file and place, quickly and in little memory. */
@Execution(ExecutionMode.CONCURRENT)
class BrokenModelFilesTest {
    private static final long MOST_BYTES = 256L << 20;

    static Stream<BrokenModelFiles> all() {
        return BrokenModelFiles.all();
    }

    private static Mesh read(String name, byte[] bytes) {
        return name.endsWith(".patch")
                ? new BezierShape(BezierPatches.read(name, bytes), 1).mesh()
                : ModelFiles.read(name, bytes, neighbour -> null);
    }

    @ParameterizedTest
    @MethodSource("all")
    void theMessageNamesTheFileAndThePlace(BrokenModelFiles broken) {
        var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long allocated = threads.getCurrentThreadAllocatedBytes();
        long cpu = threads.getCurrentThreadCpuTime();
        var problem = assertThrows(ModelFileException.class, () -> read(broken.name(), broken.bytes()));
        assertTrue(problem.getMessage().startsWith(broken.name() + broken.where()), problem.getMessage());
        assertTrue(problem.getMessage().contains("; "), "a remedy: " + problem.getMessage());
        assertEquals(broken.name(), problem.file());
        assertTrue(threads.getCurrentThreadAllocatedBytes() - allocated < MOST_BYTES, "memory");
        assertTrue(threads.getCurrentThreadCpuTime() - cpu < 1_000_000_000L, "time");
    }

    @Test
    void thereAreEnoughOfThem() {
        assertTrue(all().count() >= 60);
        assertEquals(all().count(), all().map(BrokenModelFiles::name).distinct().count());
    }

    /** Valid files with a byte or two changed, or truncated anywhere, never cause any other exception. */
    @Test
    void changedBytesNeverLeadToAnythingElse() {
        var random = new SplittableRandom(39);
        byte[][] good = {
            MeshText.of(new BoxShape(1, 1).mesh()),
            new ResourceAssets("/assets").bytes(BezierPatches.SHIPPED),
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\ns 1\nf 1/1/1 2/1/1 -1/-1/-1\n"
                    .getBytes(StandardCharsets.UTF_8),
            GltfFiles.embedded("").getBytes(StandardCharsets.UTF_8),
            GltfFiles.binary(GltfFiles.json("", ""), GltfFiles.buffer())
        };
        String[] names = {"a.3d", "a.patch", "a.obj", "a.gltf", "a.glb"};
        int refused = 0;
        for (int trial = 0; trial < 5000; trial++) {
            int kind = trial % names.length;
            byte[] bytes = changed(good[kind], random);
            try {
                read(names[kind], bytes);
            } catch (ModelFileException expected) {
                refused++;
            }
        }
        assertTrue(refused > 2500, refused + " refused");
    }

    private static byte[] changed(byte[] good, SplittableRandom random) {
        byte[] bytes = Arrays.copyOf(good, random.nextInt(4) == 0 ? random.nextInt(good.length) : good.length);
        for (int i = 0; i < 2 && bytes.length > 0; i++) {
            bytes[random.nextInt(bytes.length)] = (byte) (random.nextBoolean() ? random.nextInt(256) : '9');
        }
        return bytes;
    }
}

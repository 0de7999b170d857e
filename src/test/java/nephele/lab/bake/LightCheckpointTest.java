package nephele.lab.bake;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.IntStream;
import nephele.engine.reference.tile.PartFileException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The blocks of a bake survive whatever ends it. */
class LightCheckpointTest {
    private static final int BLOCKS = 7;
    private static final String FACTS = "light-0.bin error 2";

    @TempDir
    private Path folder;

    private Path file;

    @BeforeEach
    void write() throws IOException {
        file = folder.resolve("room.json.light.part");
        try (var checkpoint = LightCheckpoint.open(file, FACTS, BLOCKS)) {
            assertEquals(0, checkpoint.found());
            IntStream.range(0, BLOCKS).parallel().forEach(block -> checkpoint.store(block, values(block)));
        }
    }

    private static float[] values(int block) {
        float[] values = new float[10 + block];
        Arrays.fill(values, block + 0.5f);
        return values;
    }

    private static void assertHolds(LightCheckpoint checkpoint) {
        int found = 0;
        for (int block = 0; block < BLOCKS; block++) {
            if (checkpoint.known(block).isPresent()) {
                assertArrayEquals(values(block), checkpoint.known(block).get());
                found++;
            }
        }
        assertEquals(checkpoint.found(), found);
    }

    @Test
    void aFileThatIsCutOffAnywhereGoesOn() throws IOException {
        byte[] whole = Files.readAllBytes(file);
        int before = 0;
        for (int length = 0; length <= whole.length; length++) {
            Files.write(file, Arrays.copyOf(whole, length));
            try (var checkpoint = LightCheckpoint.open(file, FACTS, BLOCKS)) {
                assertHolds(checkpoint);
                assertTrue(checkpoint.found() >= before);
                before = checkpoint.found();
                for (int block = 0; block < BLOCKS; block++) {
                    if (checkpoint.known(block).isEmpty()) {
                        checkpoint.store(block, values(block));
                    }
                }
            }
            try (var again = LightCheckpoint.open(file, FACTS, BLOCKS)) {
                assertEquals(BLOCKS, again.found());
            }
        }
        assertEquals(BLOCKS, before);
    }

    @Test
    void whatIsDamagedIsWorkedOutAgain() throws IOException {
        byte[] whole = Files.readAllBytes(file);
        int head = ("nephele-light 1\n" + FACTS + "\n\n").length();
        for (int at = head; at < whole.length; at++) {
            byte[] damaged = whole.clone();
            damaged[at] ^= 64;
            Files.write(file, damaged);
            try (var checkpoint = LightCheckpoint.open(file, FACTS, BLOCKS)) {
                assertHolds(checkpoint);
                assertTrue(checkpoint.found() < BLOCKS);
            }
        }
        byte[] huge = Arrays.copyOf(whole, head + 8);
        ByteBuffer.wrap(huge).putInt(head, 0).putInt(head + 4, Integer.MAX_VALUE);
        Files.write(file, huge);
        try (var checkpoint = LightCheckpoint.open(file, FACTS, BLOCKS)) {
            assertEquals(0, checkpoint.found());
        }
    }

    @Test
    void theBlocksOfAnotherBakeAreNotUsed() throws IOException {
        try (var other = LightCheckpoint.open(file, FACTS + "0", BLOCKS)) {
            assertEquals(0, other.found());
            other.store(1, values(1));
        }
        try (var fewer = LightCheckpoint.open(file, FACTS + "0", 1)) {
            assertEquals(0, fewer.found());
        }
    }

    @Test
    void anotherKindOfFileIsKeptAndABakeThatRunsIsLeftAlone() throws IOException {
        try (var first = LightCheckpoint.open(file, FACTS, BLOCKS)) {
            assertThrows(PartFileException.class, () -> LightCheckpoint.open(file, FACTS, BLOCKS));
            first.forget();
        }
        assertFalse(Files.exists(file));
        Files.writeString(file, "a diary\n\n");
        assertThrows(PartFileException.class, () -> LightCheckpoint.open(file, FACTS, BLOCKS));
        assertEquals("a diary\n\n", Files.readString(file));
    }
}

package nephele.editor.save;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import nephele.engine.level.Level;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A change of content is told, and nothing else. */
@Execution(ExecutionMode.CONCURRENT)
class FileWatchTest {
    @TempDir
    Path folder;

    @Test
    void onlyContentsCount() throws IOException {
        Path a = folder.resolve("a");
        Path b = folder.resolve("sub").resolve("b");
        Files.writeString(a, "one");
        var files = new FileWatch(changed -> {}, null);
        files.watch(List.of(a, b));
        assertEquals(Set.of(), files.changes());
        Files.setLastModifiedTime(a, FileTime.fromMillis(1000));
        assertEquals(Set.of(), files.changes(), "a new time");
        Files.writeString(a, "two");
        Files.createDirectory(b.getParent());
        Files.writeString(b, "new");
        assertEquals(Set.of(a, b), files.changes(), "one changed, one came");
        Files.delete(a);
        assertEquals(Set.of(a), files.changes(), "one is gone");
        Files.writeString(b, "newer");
        files.watch(List.of(a, b));
        assertEquals(Set.of(b), files.changes(), "watching again forgets nothing");
        files.watch(List.of(a));
        Files.writeString(b, "newest");
        assertEquals(Set.of(), files.changes(), "no longer watched");
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void changesAreToldWithAndWithoutNotifications(boolean withNotifications) throws Exception {
        Path file = folder.resolve("a");
        Files.writeString(file, "one");
        BlockingQueue<Set<Path>> told = new LinkedBlockingQueue<>();
        try (FileWatch watch = withNotifications ? FileWatch.start(told::add) : FileWatch.looking(told::add)) {
            watch.watch(List.of(file));
            Files.writeString(file, "two");
            assertEquals(Set.of(file), told.poll(60, TimeUnit.SECONDS));
        }
    }

    @Test
    void theFilesOfALevelAreItsOwnAndThoseThatItNames() {
        Level level =
                DraftLevel.of("\"environment\": {\"sky\": {\"kind\": \"skybox\", \"layout\": \"cross\", \"files\":"
                        + " [\"sky/c.png\"]},\"clouds\": [{\"id\": \"c\", \"kind\": \"volume\", \"centre\": [0, 0, 0],"
                        + " \"size\": [1, 1, 1], \"density\": {\"kind\": \"grid\", \"file\": \"puff.vol\"},"
                        + " \"extinctionPerMetre\": 1}]},\"materials\": [{\"id\": \"m\", \"texture\": \"t.png\","
                        + " \"normalTexture\": \"n.png\"}],\"models\": [{\"id\": \"m\", \"file\": \"m/a.obj\"}]");
        assertEquals(Set.of("m/a.obj", "n.png", "puff.vol", "sky/c.png", "t.png"), NamedAssets.of(level));
        Set<Path> files = FileWatch.filesOf(folder.resolve("x.json"), level);
        assertTrue(files.containsAll(
                Set.of(folder.resolve("x.json"), folder.resolve("m").resolve("a.obj"))));
    }
}

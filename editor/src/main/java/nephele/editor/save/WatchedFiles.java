package nephele.editor.save;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/** Files with the contents that were last seen; a new time of the same content is no change. */
final class WatchedFiles {
    private static final Seen MISSING = new Seen(null, -1, "");

    private Map<Path, Seen> seen = Map.of();

    /** Time and size tell cheaply that nothing has changed. */
    private record Seen(FileTime modified, long size, String sha256) {
        boolean isSameAs(BasicFileAttributes now) {
            return now.lastModifiedTime().equals(modified) && now.size() == size;
        }
    }

    /** Replaces the files; those that stay keep what was seen of them. */
    synchronized void watch(Collection<Path> files) {
        Map<Path, Seen> next = new LinkedHashMap<>();
        for (Path file : files) {
            Path absolute = file.toAbsolutePath().normalize();
            Seen before = seen.get(absolute);
            next.put(absolute, before == null ? look(absolute, MISSING) : before);
        }
        seen = next;
    }

    /** Returns the folders that hold files. */
    synchronized Set<Path> folders() {
        Set<Path> folders = new TreeSet<>();
        seen.keySet().forEach(file -> folders.add(file.getParent()));
        return folders;
    }

    /** Returns the files whose content has changed since they were last seen, or that have come or gone. */
    synchronized Set<Path> changes() {
        Set<Path> changed = new TreeSet<>();
        for (Map.Entry<Path, Seen> each : seen.entrySet()) {
            Seen now = look(each.getKey(), each.getValue());
            if (!now.sha256.equals(each.getValue().sha256)) {
                changed.add(each.getKey());
            }
            each.setValue(now);
        }
        return changed;
    }

    private static Seen look(Path file, Seen before) {
        try {
            BasicFileAttributes now = Files.readAttributes(file, BasicFileAttributes.class);
            if (!now.isRegularFile()) {
                return MISSING;
            }
            return before.isSameAs(now) ? before : new Seen(now.lastModifiedTime(), now.size(), ContentHash.of(file));
        } catch (IOException missing) {
            return MISSING;
        }
    }
}

package nephele.editor.save;

import java.io.IOException;
import java.nio.file.ClosedWatchServiceException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Level;

/**
 * Reports when watched files change on disk. Notifications of the system make it look at once; it also looks every second,
 * because network folders and full tables of watches give none. The document's own saves are reported, too: {@link
 * DocumentFile#outside} knows them.
 */
public final class FileWatch implements AutoCloseable {
    private static final long LOOK_MILLIS = 1000;

    /** A program that writes a file in parts is waited for until it pauses this long. */
    private static final long QUIET_MILLIS = 100;

    private static final Version MISSING = new Version(null, -1, "");

    /** The watched files with what they held when they were read last. */
    private Map<Path, Version> files = Map.of();

    private final Consumer<Set<Path>> changed;
    private final WatchService service;
    private final Map<Path, WatchKey> keys = new HashMap<>();
    private volatile boolean isOpen = true;
    private final Thread thread;

    /** A file's content when it was read last; time and size tell cheaply that it has not changed. */
    private record Version(FileTime modified, long size, String sha256) {
        boolean isSameAs(BasicFileAttributes now) {
            return now.lastModifiedTime().equals(modified) && now.size() == size;
        }
    }

    /** @param service {@code null} to only look, as where the system has no notifications */
    FileWatch(Consumer<Set<Path>> changed, WatchService service) {
        this.changed = changed;
        this.service = service;
        thread = new Thread(this::run, "nephele-file-watch");
        thread.setDaemon(true);
    }

    /**
     * Starts watching no files yet.
     *
     * @param changed receives absolute paths of files that have changed, come or gone, on the watch's thread
     */
    public static FileWatch start(Consumer<Set<Path>> changed) {
        FileWatch watch = new FileWatch(changed, service());
        watch.thread.start();
        return watch;
    }

    /** Starts a watch that only looks, as where the system has no notifications. */
    static FileWatch looking(Consumer<Set<Path>> changed) {
        FileWatch watch = new FileWatch(changed, null);
        watch.thread.start();
        return watch;
    }

    private static WatchService service() {
        try {
            return FileSystems.getDefault().newWatchService();
        } catch (IOException | UnsupportedOperationException none) {
            return null;
        }
    }

    /** Returns the files of a level: its own, and every place at which an asset that it names may lie. */
    public static Set<Path> filesOf(Path levelFile, Level level) {
        LevelAssets assets = LevelAssets.beside(levelFile);
        Set<Path> files = new LinkedHashSet<>();
        files.add(levelFile);
        NamedAssets.of(level, assets).forEach(id -> files.addAll(assets.places(id)));
        return files;
    }

    /** Replaces the watched files; what new ones hold now is no change. */
    public synchronized void watch(Collection<Path> watched) {
        Map<Path, Version> next = new LinkedHashMap<>();
        for (Path file : watched) {
            Path absolute = file.toAbsolutePath().normalize();
            Version before = files.get(absolute);
            next.put(absolute, before == null ? read(absolute, MISSING) : before);
        }
        files = next;
        register();
    }

    /** Returns the files whose content has changed since they were read last, or that have come or gone. */
    synchronized Set<Path> changes() {
        Set<Path> changes = new TreeSet<>();
        for (Map.Entry<Path, Version> each : files.entrySet()) {
            Version now = read(each.getKey(), each.getValue());
            if (!now.sha256.equals(each.getValue().sha256)) {
                changes.add(each.getKey());
            }
            each.setValue(now);
        }
        return changes;
    }

    private static Version read(Path file, Version before) {
        try {
            BasicFileAttributes now = Files.readAttributes(file, BasicFileAttributes.class);
            if (!now.isRegularFile()) {
                return MISSING;
            }
            return before.isSameAs(now)
                    ? before
                    : new Version(now.lastModifiedTime(), now.size(), ContentHash.of(file));
        } catch (IOException missing) {
            return MISSING;
        }
    }

    @Override
    public void close() {
        isOpen = false;
        thread.interrupt();
        try {
            if (service != null) {
                service.close();
            }
        } catch (IOException closedAnyway) {
            return;
        }
    }

    /** Registers folders that are new, or have come back after they were deleted. */
    private synchronized void register() {
        if (service == null) {
            return;
        }
        Set<Path> folders = new TreeSet<>();
        files.keySet().forEach(file -> folders.add(file.getParent()));
        keys.entrySet().removeIf(key -> {
            boolean isGone = !folders.contains(key.getKey()) || !key.getValue().isValid();
            if (isGone) {
                key.getValue().cancel();
            }
            return isGone;
        });
        folders.stream()
                .filter(folder -> !keys.containsKey(folder) && Files.isDirectory(folder))
                .forEach(this::register);
    }

    private void register(Path folder) {
        try {
            WatchKey key = folder.register(
                    service,
                    StandardWatchEventKinds.ENTRY_CREATE,
                    StandardWatchEventKinds.ENTRY_MODIFY,
                    StandardWatchEventKinds.ENTRY_DELETE);
            keys.put(folder, key);
        } catch (IOException | ClosedWatchServiceException notWatched) {
            // The look every second finds its changes.
            return;
        }
    }

    private void run() {
        try {
            while (isOpen) {
                awaitLook();
                Set<Path> found = changes();
                if (!found.isEmpty() && isOpen) {
                    changed.accept(found);
                }
                register();
            }
        } catch (InterruptedException | ClosedWatchServiceException closed) {
            isOpen = false;
        }
    }

    private void awaitLook() throws InterruptedException {
        if (service == null) {
            TimeUnit.MILLISECONDS.sleep(LOOK_MILLIS);
            return;
        }
        WatchKey key = service.poll(LOOK_MILLIS, TimeUnit.MILLISECONDS);
        while (key != null) {
            key.pollEvents();
            key.reset();
            key = service.poll(QUIET_MILLIS, TimeUnit.MILLISECONDS);
        }
    }
}

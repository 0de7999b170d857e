package nephele.editor.save;

import java.io.IOException;
import java.nio.file.ClosedWatchServiceException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Level;

/**
 * Tells when watched files change on disk. Notifications of the system make it look at once; it also looks every second,
 * because network folders and full tables of watches give none. The document's own saves are told, too: {@link
 * DocumentFile#outside} knows them.
 */
public final class FileWatch implements AutoCloseable {
    private static final long LOOK_MILLIS = 1000;

    /** A program that writes a file in parts is waited for until it pauses this long. */
    private static final long QUIET_MILLIS = 100;

    private final WatchedFiles files = new WatchedFiles();
    private final Consumer<Set<Path>> changed;
    private final WatchService service;
    private final Map<Path, WatchKey> keys = new HashMap<>();
    private volatile boolean isOpen = true;
    private final Thread thread;

    private FileWatch(Consumer<Set<Path>> changed, WatchService service) {
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

    /** Replaces the watched files; what they hold now is no change. */
    public void watch(Collection<Path> watched) {
        files.watch(watched);
        register();
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
        Set<Path> folders = files.folders();
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
                Set<Path> found = files.changes();
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

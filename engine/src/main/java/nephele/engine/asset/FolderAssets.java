package nephele.engine.asset;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;

/**
 * Assets below one folder. A link out of the folder is rejected, and so is a name that differs from the file's in case,
 * because it would work on some systems only.
 */
public final class FolderAssets implements AssetSource {
    /** Maximum bytes of any asset file; raw heights of 8193 x 8193 samples need a little more than 128 MiB. */
    static final int MAX_FILE_BYTES = 129 << 20;

    private final Path root;

    public FolderAssets(Path root) {
        this.root = root.toAbsolutePath().normalize();
    }

    /** Returns the place of an asset, whether or not it is there. */
    Path place(String assetId) {
        return root.resolve(assetId);
    }

    @Override
    public boolean exists(String assetId) {
        return AssetId.rejectionReason(assetId) == null && Files.isRegularFile(root.resolve(assetId));
    }

    @Override
    public byte[] bytes(String assetId) {
        AssetId.check(assetId);
        Path file = root.resolve(assetId);
        try {
            requireInside(assetId, file);
            return readBounded(assetId, Files.newInputStream(file));
        } catch (IOException problem) {
            throw new AssetException(
                    assetId,
                    "cannot be read (" + problem.getClass().getSimpleName() + ")",
                    "check that " + file + " is a readable file");
        }
    }

    private void requireInside(String assetId, Path file) throws IOException {
        Path realRoot = root.toRealPath();
        if (!file.toRealPath().startsWith(realRoot)) {
            throw new AssetException(assetId, "leads out of " + root, "copy the file into the folder");
        }
        Path named = realRoot.relativize(realRoot.resolve(assetId).toRealPath(LinkOption.NOFOLLOW_LINKS));
        String onDisk = named.toString().replace('\\', '/');
        if (!onDisk.equals(assetId) && onDisk.equalsIgnoreCase(assetId)) {
            throw new AssetException(assetId, "is called " + onDisk + " on disk", "write it in the same case");
        }
        if (!Files.isRegularFile(file)) {
            throw new AssetException(assetId, "is not a regular file", "name a file");
        }
    }

    /**
     * Reads a stream to its end and closes it; throws if it has more than {@link #MAX_FILE_BYTES}, without reading on.
     */
    static byte[] readBounded(String assetId, InputStream stream) throws IOException {
        try (stream) {
            byte[] bytes = stream.readNBytes(MAX_FILE_BYTES + 1);
            if (bytes.length > MAX_FILE_BYTES) {
                throw new AssetException(
                        assetId, "is larger than " + (MAX_FILE_BYTES >> 20) + " MiB", "make it smaller");
            }
            return bytes;
        } catch (OutOfMemoryError tooLarge) {
            throw new AssetException(assetId, "does not fit into memory", "make it smaller");
        }
    }
}

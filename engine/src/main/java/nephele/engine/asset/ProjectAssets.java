package nephele.engine.asset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Collectors;

/**
 * The assets of a user's own project around one of its files. They are those of a level at that place, and beyond
 * {@link AssetId}'s grammar names with spaces and with {@code ..} that stay within the file's folder or the folder
 * above it. Links out of these are rejected.
 */
public final class ProjectAssets implements AssetSource {
    private static final String UP = "..";

    private final AssetSource strict;
    private final Path folder;
    private final Path project;

    private ProjectAssets(AssetSource strict, Path folder, Path project) {
        this.strict = strict;
        this.folder = folder;
        this.project = project;
    }

    /**
     * Returns the assets around a file; they extend to the folder above the file's folder unless that is a file system
     * root.
     */
    public static ProjectAssets around(Path file) {
        Path folder = file.toAbsolutePath().normalize().getParent();
        Path above = folder.getParent();
        boolean isWholeDisk = above == null || above.getParent() == null;
        return new ProjectAssets(LevelAssets.beside(file), folder, isWholeDisk ? folder : above);
    }

    @Override
    public String objection(String name) {
        if (AssetId.rejectionReason(name) == null) {
            return null;
        }
        String[] segments = name.split("/", -1);
        if (Arrays.stream(segments).anyMatch(segment -> !segment.equals(segment.strip()))) {
            return "no part of a name begins or ends with a space";
        }
        // Spaces are removed, because a Windows device name with spaces is a device as well.
        String likened = Arrays.stream(segments)
                .filter(segment -> !segment.equals(UP))
                .map(segment -> segment.replace(" ", ""))
                .collect(Collectors.joining("/"));
        String objection = AssetId.rejectionReason(name.length() > AssetId.MAX_CHARACTERS ? name : likened);
        if (objection != null) {
            return objection;
        }
        return path(name).startsWith(project) ? null : "it leads out of " + project;
    }

    @Override
    public boolean exists(String name) {
        return strict.exists(name) || objection(name) == null && Files.isRegularFile(path(name));
    }

    @Override
    public byte[] bytes(String name) {
        if (AssetId.rejectionReason(name) == null) {
            return strict.bytes(name);
        }
        String objection = objection(name);
        if (objection != null) {
            throw new AssetException(AssetId.printable(name), objection, "name a file of the project");
        }
        try {
            return FolderAssets.readBounded(name, Files.newInputStream(real(name)));
        } catch (IOException problem) {
            throw new AssetException(
                    name,
                    "cannot be read (" + problem.getClass().getSimpleName() + ")",
                    "check that " + path(name) + " is a readable file");
        }
    }

    /**
     * Resolves links and checks the result, which is then opened, so that a change of links in between has no effect.
     */
    private Path real(String name) throws IOException {
        Path real = path(name).toRealPath();
        if (!real.startsWith(folder.toRealPath()) && !real.startsWith(project.toRealPath())) {
            throw new AssetException(name, "is a link that leads out of " + project, "copy the file into the project");
        }
        if (!Files.isRegularFile(real)) {
            throw new AssetException(name, "is not a regular file", "name a file");
        }
        return real;
    }

    private Path path(String name) {
        return folder.resolve(name).normalize();
    }
}

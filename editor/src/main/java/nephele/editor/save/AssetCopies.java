package nephele.editor.save;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import nephele.editor.text.Words;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Level;

/** Takes the files that a level needs along to the folder that it is saved to; no file there is replaced. */
final class AssetCopies {
    private AssetCopies() {}

    /**
     * Copies what a level at its new place would not find, or find otherwise.
     *
     * @param from the files of the level where it is now
     * @return why the level cannot be saved there; a file that cannot be read is left to the level's check
     */
    static Optional<Words> copy(Level level, AssetSource from, Path levelFile) {
        LevelAssets there = LevelAssets.beside(levelFile);
        List<String> copies = new ArrayList<>();
        for (String id : NamedAssets.of(level, from)) {
            if (!from.exists(id) || isSame(id, from, there)) {
                continue;
            }
            Path place = levelFile.resolveSibling(id);
            if (Files.exists(place)) {
                return Optional.of(SaveText.ASSET_TAKEN.with(place));
            }
            copies.add(id);
        }
        for (String id : copies) {
            Path place = levelFile.resolveSibling(id);
            try {
                Files.createDirectories(place.toAbsolutePath().getParent());
                AtomicFile.write(place, from.bytes(id));
            } catch (IOException problem) {
                return Optional.of(DocumentSaver.message(place, problem));
            } catch (AssetException unreadable) {
                continue;
            }
        }
        return Optional.empty();
    }

    private static boolean isSame(String id, AssetSource from, AssetSource there) {
        try {
            return there.exists(id) && Arrays.equals(there.bytes(id), from.bytes(id));
        } catch (AssetException unreadable) {
            return false;
        }
    }
}

package nephele.editor.paint;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;

/** Materials that the editor offers to every level. A level gets a copy of the one that it uses first. */
public final class MaterialLibrary {
    /** The material of the first brush of a new level. */
    public static final String FIRST = "plaster";

    /** The materials made of the pictures that come with the game. */
    public static final MaterialLibrary STANDARD = read("materials.json");

    private final List<Material> materials;

    private MaterialLibrary(List<Material> materials) {
        this.materials = List.copyOf(materials);
    }

    private static MaterialLibrary read(String resource) {
        try (InputStream file = MaterialLibrary.class.getResourceAsStream(resource)) {
            return new MaterialLibrary(
                    LevelJson.read(resource, file.readAllBytes()).materials());
        } catch (IOException | LevelFormatException damaged) {
            throw new UncheckedIOException(new IOException(resource + " of the editor cannot be read", damaged));
        }
    }

    /** Returns the materials in the order in which they are offered. */
    public List<Material> materials() {
        return materials;
    }

    /** Returns those that the level has no material of the same id for. */
    public List<Material> missingIn(Level level) {
        return materials.stream()
                .filter(material -> find(level.materials(), material.id()).isEmpty())
                .toList();
    }

    /** Returns the material of an id, of the level before that of the library; empty if neither has it. */
    public Optional<Material> find(Level level, String id) {
        return find(level.materials(), id).or(() -> find(materials, id));
    }

    /** Returns the level with the material if the library has it and the level does not; else the same level. */
    public Level including(Level level, String id) {
        Optional<Material> added = find(level.materials(), id).isPresent() ? Optional.empty() : find(materials, id);
        if (added.isEmpty()) {
            return level;
        }
        List<Material> all = new ArrayList<>(level.materials());
        all.add(added.get());
        return level.with(all, level.solids());
    }

    private static Optional<Material> find(List<Material> among, String id) {
        return among.stream().filter(material -> material.id().equals(id)).findFirst();
    }
}

package nephele.editor.terrain;

import java.util.Optional;
import java.util.OptionalDouble;
import nephele.editor.text.Words;
import nephele.engine.level.Terrain;

/** A stroke that goes on: it makes a new map of a terrain. */
interface TerrainStroke {
    /** Goes on straight to a place. */
    void to(double x, double z);

    /** Returns true if the map is worth showing: it may differ from the one before the stroke. */
    boolean isTouched();

    /** Returns true if the map differs from the one before the stroke. */
    boolean isChange();

    /** Returns the map now; what was returned before does not change. */
    PaintedMaps.PaintedMap painted();

    /** Returns a terrain with a map of this stroke. */
    Terrain on(Terrain said, String map);

    /** Returns the beginning of the file's name. */
    String name(Terrain said);

    /** Returns the height of a place above the terrain's centre; empty if the stroke changes no heights. */
    OptionalDouble height(double x, double z);

    /** Returns what the user should know while the stroke goes on; empty for nothing. */
    Optional<Words> notice();

    /** Returns the reason why the stroke has changed nothing; empty if there is none to tell. */
    Optional<Words> objection();
}

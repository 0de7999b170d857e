package nephele.engine.render.frame;

import java.util.Optional;
import nephele.engine.level.Level;
import nephele.engine.level.MirrorFaces;
import nephele.engine.level.appearance.FogTransmittance;

/** Why a level's light is summed up in a linear target before it is tone-mapped: something adds light to what is drawn. */
public final class LinearLight {
    private LinearLight() {}

    /** Empty where nothing in the level is added. */
    public static Optional<String> because(Level level) {
        int tinted = MirrorFaces.firstTinted(level);
        return tinted < 0 || FogTransmittance.of(level.environment()).isEmpty()
                ? Optional.empty()
                : Optional.of("materials[" + tinted + "].mirror: fog before it is added to what it tints");
    }
}

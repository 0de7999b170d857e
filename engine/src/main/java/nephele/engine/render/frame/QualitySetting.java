package nephele.engine.render.frame;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Declares a setting: its values, those that the presets have, and what it trades. It stands on a component of
 * {@link Quality} or of the settings of a picture, whose name and type are the setting's. The presets, {@code --set} and
 * its help, and the subject of the speed and accuracy report follow from it.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface QualitySetting {
    /** The value of the preset {@code high}, as {@code --set} writes it. */
    String high();

    /** The value of {@code low}; empty for that of {@code high}. */
    String low() default "";

    /** The value of {@code medium}; empty for that of {@code high}. */
    String medium() default "";

    /** The value of {@code ultra}; empty for that of {@code high}. */
    String ultra() default "";

    /** Least number; unused by words. */
    double least() default 0;

    /** Greatest number; 1 for shares. Unused by words. */
    double most() default 1;

    /** Its name in {@code --set}; empty for that of the component. */
    String name() default "";

    /** Its title in the report: a few words. */
    String title();

    /** Its effect, and what a cheaper value loses, in a sentence or two. */
    String about();
}

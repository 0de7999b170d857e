package nephele.editor.draw;

import java.util.concurrent.Executor;

/**
 * The threads beside the one that draws a viewport.
 *
 * @param soon runs what the picture waits for, such as the visibility of a sky
 * @param baking runs bakes of light, which take minutes and give way to everything else
 * @param repaintSoon called on these threads if the next frame would differ
 */
public record BackgroundWork(Executor soon, Executor baking, Runnable repaintSoon) {}

/** Draws bolts of lightning as lines whose light does not depend on how thin they are. */
package nephele.engine.render.pass.lightning;

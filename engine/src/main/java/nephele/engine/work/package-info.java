/** Where long work may be done. */
package nephele.engine.work;

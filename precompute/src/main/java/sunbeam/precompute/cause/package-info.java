/** Which source of error an answer misses its tolerance by: a plan in double precision, its approximations switched one by one. */
package sunbeam.precompute.cause;
